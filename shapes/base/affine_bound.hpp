#pragma once

#include <Eigen/Geometry>

#include <algorithm>
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

}  // namespace gridstep
