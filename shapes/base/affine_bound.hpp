#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>

#include "shapes/base/lattice.hpp"

namespace gridstep {

template <int d>
using RealBox = Eigen::AlignedBox<double, d>;

/// The greatest absolute value of a coordinate of a point of the box.
template <int d>
double greatest_coordinate(const RealBox<d>& box) {
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

/// Where a box lies with respect to a region. `crossing` also stands for "not decided".
enum class Side { inside, outside, crossing };

/// What is known of a region over a box: an affine function that decides it, but for a slab around its zeros.
/// At every double point p of the box, with L(p) = value + slope . (p - centre) in exact arithmetic,
///   L(p) < -error  =>  the computed membership of p is true,    L(p) > error  =>  it is false.
/// Who moves the function or evaluates it in doubles adds his own rounding to `error`.
template <int d>
struct AffineBound {
  RealPoint<d> centre = RealPoint<d>::Zero();
  double value = 0;
  RealPoint<d> slope = RealPoint<d>::Zero();
  double error = std::numeric_limits<double>::infinity();

  /// What decides everywhere, or nothing.
  static AffineBound constant(Side side) {
    AffineBound bound;
    if (side == Side::crossing) return bound;
    bound.value = side == Side::inside ? -1 : 1;
    bound.error = 0;
    return bound;
  }

  /// Far more than the rounding of a comparison of L with its error at points whose coordinates are at most
  /// `magnitude` in absolute value.
  double rounding(double magnitude) const {
    const double reach = magnitude + centre.template lpNorm<Eigen::Infinity>();
    return 1e-13 * (std::abs(value) + error + slope.template lpNorm<1>() * reach);
  }

  /// The side of the box, or of a part of it.
  Side side(const RealBox<d>& box) const {
    const RealPoint<d> low = box.min() - centre, high = box.max() - centre;
    double least = value, greatest = value;
    for (int k = 0; k < d; ++k) {
      const double a = slope[k] * low[k], b = slope[k] * high[k];
      least += std::min(a, b);
      greatest += std::max(a, b);
    }
    const double margin = error + rounding(greatest_coordinate(box));
    return least > margin ? Side::outside : greatest < -margin ? Side::inside : Side::crossing;
  }
};

/// Over a box, the bound of the intersection of two regions: undecided where both may cut the box.
template <int d>
AffineBound<d> intersection(const AffineBound<d>& a, const AffineBound<d>& b, const RealBox<d>& box) {
  const Side of_a = a.side(box), of_b = b.side(box);
  if (of_a == Side::outside || of_b == Side::inside) return a;
  if (of_b == Side::outside || of_a == Side::inside) return b;
  return AffineBound<d>::constant(Side::crossing);
}

/// The bound of the half-space normal . p <= offset, its left side summed in the order of the coordinates.
template <int d>
AffineBound<d> half_space_bound(const RealPoint<d>& normal, double offset, const RealBox<d>& box) {
  AffineBound<d> bound{box.center(), 0, normal, 0};
  bound.value = normal.dot(bound.centre) - offset;
  const RealPoint<d> far = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  bound.error = 1e-14 * (normal.cwiseAbs().dot(far) + std::abs(offset));
  return bound;
}

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
