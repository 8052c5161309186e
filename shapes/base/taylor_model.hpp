#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "shapes/base/affine_bound.hpp"

namespace gridstep {

/// A value over a box that is quadratic up to an error, for expressions in +, - and *: at every double point p
/// of the box, the value that the same expression, evaluated in the same order, takes in doubles is within
/// `error` of
///   value + sum_k slope[k] x_k + sum_{j <= k} bend[(j, k)] x_j x_k,
/// where x_k in [-1, 1] is p_k as seen from the middle of the box.
///
/// Tight to third order: `error` shrinks with the cube of the box, down to the rounding at its points. A model of
/// order 1 would be cheaper, but looser: where terms cancel, as in a torus, so do their bends, but not their errors.
/// This is a Taylor model of order 2 [Berz, Makino] around floating-point values.
template <int d>
struct TaylorModel {
  double value = 0;
  std::array<double, d> slope{};
  std::array<double, d*(d + 1) / 2> bend{};  ///< in 3D of xx, xy, xz, yy, yz, zz
  double error = 0;

  // An operation rounds its result in doubles, and each number of its model, by a few units of 1.1e-16.
  static constexpr double kRounding = 1e-14, kUnderflow = 1e-300;

  TaylorModel() = default;
  explicit TaylorModel(double constant) : value(constant) {}

  static TaylorModel variable(double lo, double hi, int k) {
    TaylorModel x(lo + (hi - lo) / 2);
    x.slope[std::size_t(k)] = std::max(hi - x.value, x.value - lo);
    return x;
  }
  static std::array<TaylorModel, d> variables(const RealBox<d>& box) {
    std::array<TaylorModel, d> result;
    for (int k = 0; k < d; ++k) result[std::size_t(k)] = variable(box.min()[k], box.max()[k], k);
    return result;
  }

  /// A bound on the absolute value over the box.
  double magnitude() const { return std::abs(value) + error + sum(slope) + sum(bend); }

  friend TaylorModel operator+(const TaylorModel& a, const TaylorModel& b) { return combined(a, b, 1); }
  friend TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) { return combined(a, b, -1); }
  friend TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel c(a.value * b.value);
    for (std::size_t j = 0, pair = 0; j < d; ++j) {
      c.slope[j] = a.value * b.slope[j] + b.value * a.slope[j];
      for (std::size_t k = j; k < d; ++k, ++pair)
        c.bend[pair] = a.value * b.bend[pair] + b.value * a.bend[pair] + a.slope[j] * b.slope[k] +
                       (j == k ? 0 : a.slope[k] * b.slope[j]);
    }
    const double slope_a = sum(a.slope), slope_b = sum(b.slope), bend_a = sum(a.bend), bend_b = sum(b.bend);
    const double greatest_a = a.magnitude(), greatest_b = b.magnitude();
    c.error = slope_a * bend_b + bend_a * slope_b + bend_a * bend_b + a.error * greatest_b +
              b.error * greatest_a + kRounding * greatest_a * greatest_b + kUnderflow;
    return c;
  }
  friend TaylorModel scaled(const TaylorModel& a, double factor) {
    TaylorModel c(a.value * factor);
    for (std::size_t k = 0; k < a.slope.size(); ++k) c.slope[k] = a.slope[k] * factor;
    for (std::size_t k = 0; k < a.bend.size(); ++k) c.bend[k] = a.bend[k] * factor;
    c.error = std::abs(factor) * (a.error + kRounding * a.magnitude()) + kUnderflow;
    return c;
  }
  friend TaylorModel square(const TaylorModel& a) { return a * a; }

 private:
  template <std::size_t n>
  static double sum(const std::array<double, n>& numbers) {
    double result = 0;
    for (const double number : numbers) result += std::abs(number);
    return result;
  }
  static TaylorModel combined(const TaylorModel& a, const TaylorModel& b, double sign) {
    TaylorModel c(a.value + sign * b.value);
    for (std::size_t k = 0; k < a.slope.size(); ++k) c.slope[k] = a.slope[k] + sign * b.slope[k];
    for (std::size_t k = 0; k < a.bend.size(); ++k) c.bend[k] = a.bend[k] + sign * b.bend[k];
    c.error = a.error + b.error;
    c.error += kRounding * (a.magnitude() + b.magnitude());
    return c;
  }
};

/// The bound of {f <= 0} over a box, from the model of f in TaylorModel::variables(box). What bends is replaced by
/// the middle of its range, and its reach from there is part of the error: since 2 |x_j x_k| <= x_j^2 + x_k^2, each
/// x_j^2 in [0, 1] has a least and a greatest coefficient.
template <int d>
AffineBound<d> bound_of(const TaylorModel<d>& f, const RealBox<d>& box) {
  const std::array<TaylorModel<d>, d> variables = TaylorModel<d>::variables(box);
  AffineBound<d> bound;
  std::array<double, d> least{}, greatest{};
  for (std::size_t j = 0, pair = 0; j < d; ++j)
    for (std::size_t k = j; k < d; ++k, ++pair) {
      if (j == k) {
        least[j] += f.bend[pair];
        greatest[j] += f.bend[pair];
        continue;
      }
      const double half = std::abs(f.bend[pair]) / 2;
      for (const std::size_t i : {j, k}) {
        least[i] -= half;
        greatest[i] += half;
      }
    }
  bound.value = f.value;
  bound.error = f.error + TaylorModel<d>::kRounding * f.magnitude();
  for (int k = 0; k < d; ++k) {
    const double lo = std::min(least[std::size_t(k)], 0.0), hi = std::max(greatest[std::size_t(k)], 0.0);
    bound.value += (hi + lo) / 2;
    bound.error += (hi - lo) / 2;
    const double reach = variables[std::size_t(k)].slope[std::size_t(k)];
    bound.centre[k] = variables[std::size_t(k)].value;
    bound.slope[k] = reach > 0 ? f.slope[std::size_t(k)] / reach : 0;
  }
  return bound;
}

}  // namespace gridstep
