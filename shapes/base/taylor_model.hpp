#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "shapes/base/quadratic_bound.hpp"

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
  static constexpr int kPairs = d * (d + 1) / 2;

  using Terms = Eigen::Array<double, 1 + d + kPairs, 1>;

  Terms terms = Terms::Zero();  ///< the value, the slopes, and the bends: in 3D of xx, xy, xz, yy, yz, zz
  double error = 0;
  double magnitude = 0;  ///< a bound on the absolute value over the box

  double value() const { return terms[0]; }
  auto slope() const { return terms.template segment<d>(1); }
  auto bend() const { return terms.template tail<kPairs>(); }
  /// The sum of the absolute values of the slopes: half the range of the affine part.
  double sloping() const { return sum_of(1, 1 + d); }

  // An operation rounds its result in doubles, and each number of its model, by a few units of 1.1e-16.
  static constexpr double kRounding = 1e-14, kUnderflow = 1e-300;

  TaylorModel() = default;
  explicit TaylorModel(double constant) : magnitude(std::abs(constant)) { terms[0] = constant; }

  static std::array<TaylorModel, d> variables(const RealBox<d>& box) {
    const RealPoint<d> middle = box.center(), reach = reach_of(box);
    std::array<TaylorModel, d> result;
    for (int k = 0; k < d; ++k) {
      TaylorModel& x = result[std::size_t(k)];
      x.terms[0] = middle[k];
      x.terms[1 + k] = reach[k];
      x.magnitude = std::abs(middle[k]) + reach[k];
    }
    return result;
  }
  /// How far the box reaches from its middle.
  static RealPoint<d> reach_of(const RealBox<d>& box) {
    return (box.max() - box.center()).cwiseMax(box.center() - box.min());
  }

  friend TaylorModel operator+(const TaylorModel& a, const TaylorModel& b) {
    return {a.terms + b.terms, a.error + b.error + kRounding * (a.magnitude + b.magnitude)};
  }
  friend TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) {
    return {a.terms - b.terms, a.error + b.error + kRounding * (a.magnitude + b.magnitude)};
  }
  friend TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel c;
    c.terms[0] = a.value() * b.value();
    for (int k = 1; k <= d; ++k) c.terms[k] = a.value() * b.terms[k] + b.value() * a.terms[k];
    for (int j = 1, pair = 1 + d; j <= d; ++j)
      for (int k = j; k <= d; ++k, ++pair)
        c.terms[pair] = a.value() * b.terms[pair] + b.value() * a.terms[pair] + a.terms[j] * b.terms[k] +
                        (j == k ? 0 : a.terms[k] * b.terms[j]);
    const double bend_a = a.bending(), bend_b = b.bending();
    c.set_error(a.sloping() * bend_b + bend_a * (b.sloping() + bend_b) + a.error * b.magnitude +
                b.error * a.magnitude + kRounding * a.magnitude * b.magnitude + kUnderflow);
    return c;
  }
  friend TaylorModel scaled(const TaylorModel& a, double factor) {
    return {a.terms * factor, std::abs(factor) * (a.error + kRounding * a.magnitude) + kUnderflow};
  }
  friend TaylorModel square(const TaylorModel& a) {
    const double twice = 2 * a.value();
    TaylorModel c;
    c.terms[0] = a.value() * a.value();
    for (int k = 1; k <= d; ++k) c.terms[k] = twice * a.terms[k];
    for (int j = 1, pair = 1 + d; j <= d; ++j)
      for (int k = j; k <= d; ++k, ++pair)
        c.terms[pair] = twice * a.terms[pair] + (j == k ? 1 : 2) * a.terms[j] * a.terms[k];
    const double bend = a.bending();
    c.set_error(bend * (2 * a.sloping() + bend) + 2 * a.error * a.magnitude +
                kRounding * a.magnitude * a.magnitude + kUnderflow);
    return c;
  }

 private:
  template <class Expression>
  TaylorModel(const Expression& terms_, double error_) : terms(terms_) {
    set_error(error_);
  }
  void set_error(double e) {
    error = e;
    magnitude = sum_of(0, terms.size()) + e;
  }
  double bending() const { return sum_of(1 + d, terms.size()); }
  /// Of the absolute values of some terms, one after the other.
  double sum_of(Eigen::Index begin, Eigen::Index end) const {
    double result = std::abs(terms[begin]);
    for (Eigen::Index i = begin + 1; i < end; ++i) result += std::abs(terms[i]);
    return result;
  }
};

/// The bound of {f <= 0} over a box, from the model of f in TaylorModel::variables(box).
template <int d>
QuadraticBound<d> bound_of(const TaylorModel<d>& f, const RealBox<d>& box) {
  const RealPoint<d> reach = TaylorModel<d>::reach_of(box);
  QuadraticBound<d> bound;
  bound.centre = box.center();
  bound.value = f.value();
  bound.error = f.error + TaylorModel<d>::kRounding * f.magnitude + QuadraticBound<d>::underflow(reach.sum());
  RealPoint<d> in_reach;
  for (int k = 0; k < d; ++k) in_reach[k] = reach[k] > 0 ? 1 / reach[k] : 0;
  bound.slope = f.slope().matrix().cwiseProduct(in_reach);
  for (int j = 0, pair = 0; j < d; ++j)
    for (int k = j; k < d; ++k, ++pair)
      bound.bend(j, k) = bound.bend(k, j) = f.bend()[pair] * (j == k ? 1 : 0.5) * in_reach[j] * in_reach[k];
  return bound;
}

}  // namespace gridstep
