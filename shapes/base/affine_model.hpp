#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "shapes/base/affine_bound.hpp"

namespace gridstep {

/// A value over a box that is affine up to an error, for expressions in +, - and *: at every double point p
/// of the box, the value that the same expression, evaluated in the same order, takes in doubles is within
/// `error` of value + sum_k slope[k] x_k, where x_k in [-1, 1] is p_k as seen from the middle of the box.
///
/// Tight to second order: `error` shrinks with the square of the box, down to the rounding at its points.
/// This is a Taylor model of order 1 [Berz, Makino] around floating-point values.
template <int d>
struct AffineModel {
  double value = 0;
  std::array<double, d> slope{};
  double error = 0;

  AffineModel() = default;
  explicit AffineModel(double constant) : value(constant) {}

  static AffineModel variable(double lo, double hi, int k) {
    AffineModel x(lo + (hi - lo) / 2);
    x.slope[std::size_t(k)] = std::max(hi - x.value, x.value - lo);
    return x;
  }
  static std::array<AffineModel, d> variables(const RealBox<d>& box) {
    std::array<AffineModel, d> result;
    for (int k = 0; k < d; ++k) result[k] = variable(box.min()[k], box.max()[k], k);
    return result;
  }

  /// A bound on the absolute value over the box.
  double magnitude() const {
    double sum = std::abs(value) + error;
    for (const double s : slope) sum += std::abs(s);
    return sum;
  }

  friend AffineModel operator+(const AffineModel& a, const AffineModel& b) { return combined(a, b, 1); }
  friend AffineModel operator-(const AffineModel& a, const AffineModel& b) { return combined(a, b, -1); }
  friend AffineModel operator*(const AffineModel& a, const AffineModel& b) {
    // Of the product of the slopes, x_k^2 lies in [0, 1] and x_j x_k in [-1, 1].
    AffineModel c(a.value * b.value);
    double quadratic = 0;
    for (int j = 0; j < d; ++j) {
      const double half = a.slope[j] * b.slope[j] / 2;
      c.value += half;
      quadratic += std::abs(half);
      for (int k = 0; k < j; ++k) quadratic += std::abs(a.slope[j] * b.slope[k] + a.slope[k] * b.slope[j]);
      c.slope[j] = a.value * b.slope[j] + b.value * a.slope[j];
    }
    const double greatest_a = a.magnitude(), greatest_b = b.magnitude();
    c.error = quadratic + a.error * greatest_b + b.error * greatest_a + kRounding * greatest_a * greatest_b +
              kUnderflow;
    return c;
  }
  friend AffineModel scaled(const AffineModel& a, double factor) {
    AffineModel c(a.value * factor);
    for (int k = 0; k < d; ++k) c.slope[k] = a.slope[k] * factor;
    c.error = std::abs(factor) * (a.error + kRounding * a.magnitude()) + kUnderflow;
    return c;
  }
  friend AffineModel square(const AffineModel& a) {
    // The square of the slopes lies in [0, spread^2].
    double spread = 0;
    AffineModel c(a.value * a.value);
    for (int k = 0; k < d; ++k) {
      spread += std::abs(a.slope[k]);
      c.slope[k] = 2 * a.value * a.slope[k];
    }
    const double half = spread * spread / 2, greatest = a.magnitude();
    c.value += half;
    c.error = half + 2 * a.error * greatest + kRounding * greatest * greatest + kUnderflow;
    return c;
  }

 private:
  // An operation rounds its result in doubles, and each number of its model, by a few units of 1.1e-16.
  static constexpr double kRounding = 1e-14, kUnderflow = 1e-300;

  static AffineModel combined(const AffineModel& a, const AffineModel& b, double sign) {
    AffineModel c(a.value + sign * b.value);
    for (int k = 0; k < d; ++k) c.slope[k] = a.slope[k] + sign * b.slope[k];
    c.error = a.error + b.error;
    c.error += kRounding * (a.magnitude() + b.magnitude());
    return c;
  }
};

/// The bound of {f <= 0} over a box, from the model of f in AffineModel::variables(box).
template <int d>
AffineBound<d> bound_of(const AffineModel<d>& f, const RealBox<d>& box) {
  const std::array<AffineModel<d>, d> variables = AffineModel<d>::variables(box);
  AffineBound<d> bound;
  bound.value = f.value;
  bound.error = f.error;
  for (int k = 0; k < d; ++k) {
    const double reach = variables[k].slope[k];
    bound.centre[k] = variables[k].value;
    bound.slope[k] = reach > 0 ? f.slope[k] / reach : 0;
  }
  return bound;
}

}  // namespace gridstep
