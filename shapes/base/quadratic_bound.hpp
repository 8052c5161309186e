#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "shapes/base/lattice.hpp"

namespace gridstep {

template <int d>
using RealBox = Eigen::AlignedBox<double, d>;

template <int d>
using RealMatrix = Eigen::Matrix<double, d, d>;

/// The greatest absolute value of a coordinate of a point of the box.
template <int d>
double greatest_coordinate(const RealBox<d>& box) {
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

/// Where a box lies with respect to a region. `crossing` also stands for "not decided".
enum class Side { inside, outside, crossing };

/// What is known of a region over a box: a quadratic function that decides it, but for a shell around its zeros.
/// At every double point p of the box, with Q(p) = value + slope . x + x . bend x in exact arithmetic, x = p - centre,
///   Q(p) < -error  =>  the computed membership of p is true,    Q(p) > error  =>  it is false.
/// Who moves the function or evaluates it in doubles adds his own rounding to `error`.
template <int d>
struct QuadraticBound {
  RealPoint<d> centre = RealPoint<d>::Zero();
  double value = 0;
  RealPoint<d> slope = RealPoint<d>::Zero();
  RealMatrix<d> bend = RealMatrix<d>::Zero();  ///< symmetric: half the second derivatives
  double error = std::numeric_limits<double>::infinity();

  /// What decides everywhere, or nothing.
  static QuadraticBound constant(Side side) {
    QuadraticBound bound;
    if (side == Side::crossing) return bound;
    bound.value = side == Side::inside ? -1 : 1;
    bound.error = 0;
    return bound;
  }

  /// Q(p) and its gradient there.
  double operator()(const RealPoint<d>& p) const {
    const RealPoint<d> x = p - centre;
    return value + x.dot(slope + bend * x);
  }
  RealPoint<d> gradient(const RealPoint<d>& p) const { return slope + 2 * (bend * (p - centre)); }

  /// Far more than the rounding of a comparison of Q with its error at points whose coordinates are at most
  /// `magnitude` in absolute value.
  double rounding(double magnitude) const {
    const double reach = magnitude + centre.template lpNorm<Eigen::Infinity>();
    return 1e-13 * (std::abs(value) + error +
                    reach * (slope.template lpNorm<1>() + reach * bend.template lpNorm<1>())) +
           underflow(reach);
  }
  /// Far more than what is lost where slopes or bends, or products of them, are too small for a double, at points at
  /// most `reach` away. Not itself so small: processors take long for such numbers.
  static double underflow(double reach) { return 1e-300 * (1 + reach) * (1 + reach); }

  /// Bounds on x . bend x where |x_k| <= reach_k: since 2 |x_j x_k| <= s x_j^2 + x_k^2 / s, here with
  /// s = reach_k / reach_j, each (x_k / reach_k)^2 in [0, 1] has a least and a greatest coefficient.
  std::pair<double, double> range_of_bend(const RealPoint<d>& reach) const {
    double lowest = 0, highest = 0;
    for (int k = 0; k < d; ++k) {
      const double own = bend(k, k) * reach[k] * reach[k];
      double mixed = 0;
      for (int j = 0; j < d; ++j)
        if (j != k) mixed += std::abs(bend(j, k)) * reach[j] * reach[k];
      lowest += std::min(0.0, own - mixed);
      highest += std::max(0.0, own + mixed);
    }
    return {lowest, highest};
  }

  /// The side of the box, or of a part of it.
  Side side(const RealBox<d>& box) const {
    const RealPoint<d> middle = box.center(), reach = box.sizes() / 2;
    const auto [lowest, highest] = range_of_bend(reach);
    const double at_middle = (*this)(middle), sloping = gradient(middle).cwiseAbs().dot(reach);
    const double margin = error + rounding(greatest_coordinate(box));
    return of_range(at_middle - sloping + lowest - margin, at_middle + sloping + highest + margin);
  }

  /// The side where Q takes values of this range, widened by all errors.
  static Side of_range(double lowest, double highest) {
    return lowest > 0 ? Side::outside : highest < 0 ? Side::inside : Side::crossing;
  }
};

/// What a bound says of the 2^d parts of a box, all at once: of one size, their middles at middle_k +- offset_k, with +
/// where bit k of the number of the part is set.
template <int d>
class BoundOfParts {
 public:
  /// @param reach half the size of a part
  BoundOfParts(const QuadraticBound<d>& bound, const RealPoint<d>& middle, const RealPoint<d>& offset,
               const RealPoint<d>& reach) {
    const RealPoint<d> slope = bound.gradient(middle);
    Parts value = Parts::Constant(bound(middle)), sloping = Parts::Zero();
    for (int k = 0; k < d; ++k) {
      Parts change = Parts::Zero();  // of half the slope from the middle of the box
      for (int j = 0; j < d; ++j) change += (bound.bend(j, k) * offset[j]) * sign(j);
      const Parts steepness = (slope[k] + 2 * change).abs();
      value += offset[k] * sign(k) * (slope[k] + change);
      sloping += reach[k] * steepness;
      steepest_ = steepest_.max(steepness);
    }
    const auto [lowest, highest] = bound.range_of_bend(reach);
    const RealPoint<d> far = middle.cwiseAbs() + offset + reach;
    const double margin = bound.error + bound.rounding(far.maxCoeff());
    lowest_ = value - sloping + (lowest - margin);
    highest_ = value + sloping + (highest + margin);
  }

  Side side(int part) const { return QuadraticBound<d>::of_range(lowest_[part], highest_[part]); }
  /// The greatest slope along an axis in the middle of a part.
  double slope(int part) const { return steepest_[part]; }

 private:
  using Parts = Eigen::Array<double, 1 << d, 1>;

  static Parts sign(int axis) {
    Parts result;
    for (int part = 0; part < (1 << d); ++part) result[part] = (part >> axis) & 1 ? 1 : -1;
    return result;
  }

  Parts lowest_, highest_, steepest_ = Parts::Zero();
};

/// The bound over a box of the intersection of regions: undecided where several of them may cut the box.
template <int d>
class BoundOfIntersection {
 public:
  explicit BoundOfIntersection(const RealBox<d>& box) : box_(box) {}

  /// Another region, by its bound.
  void add(const QuadraticBound<d>& bound) {
    if (side_ == Side::outside) return;
    const Side side = bound.side(box_);
    if (side == Side::inside) return;
    bound_ =
        side == Side::outside || side_ == Side::inside ? bound : QuadraticBound<d>::constant(Side::crossing);
    side_ = side;
  }
  /// The half-space normal . p <= offset, its left side summed in the order of the coordinates.
  void add_half_space(const RealPoint<d>& normal, double offset) {
    const RealPoint<d> centre = box_.center(), far = box_.min().cwiseAbs().cwiseMax(box_.max().cwiseAbs());
    const double value = normal.dot(centre) - offset,
                 rounding = 1e-14 * (normal.cwiseAbs().dot(far) + std::abs(offset));
    const double margin = 10 * rounding + QuadraticBound<d>::underflow(far.sum());
    if (value + normal.cwiseAbs().dot(box_.sizes() / 2) < -margin) return;  // as most are
    QuadraticBound<d> bound;
    bound.centre = centre;
    bound.value = value;
    bound.slope = normal;
    bound.error = rounding;
    add(bound);
  }

  const QuadraticBound<d>& bound() const { return bound_; }

 private:
  RealBox<d> box_;
  QuadraticBound<d> bound_ = QuadraticBound<d>::constant(Side::inside);
  Side side_ = Side::inside;  // of bound_
};

}  // namespace gridstep
