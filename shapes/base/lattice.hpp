#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

namespace gridstep {

/// A point of Z^d: the coordinates of a digital point, or those of a displacement.
template <int d>
using LatticePoint = Eigen::Matrix<int, d, 1>;

/// A point or a vector of R^d, in the unit of the shape.
template <int d>
using RealPoint = Eigen::Matrix<double, d, 1>;

/// The digital points lo <= z <= hi, both ends included; empty where hi < lo in some direction.
template <int d>
struct LatticeBox {
  LatticePoint<d> lo, hi;

  bool empty() const { return (hi.array() < lo.array()).any(); }
  bool contains(const LatticePoint<d>& z) const {
    return (z.array() >= lo.array()).all() && (z.array() <= hi.array()).all();
  }
  /// Number of points in each direction.
  LatticePoint<d> extent() const { return (hi - lo).array() + 1; }
  /// Number of points; a double, since a box may hold more than 2^63 of them.
  double volume() const { return empty() ? 0.0 : extent().template cast<double>().prod(); }
  /// All points at most `margin` away in the maximum norm.
  LatticeBox dilated(int margin) const { return {lo.array() - margin, hi.array() + margin}; }
  LatticeBox intersection(const LatticeBox& other) const {
    return {lo.cwiseMax(other.lo), hi.cwiseMin(other.hi)};
  }
};

/// Calls visit(z) for every point of the box in raster order.
template <int d, class Visit>
void for_each_point(const LatticeBox<d>& box, Visit visit) {
  if (box.empty()) return;
  LatticePoint<d> z = box.lo;
  while (true) {
    for (z[0] = box.lo[0]; z[0] <= box.hi[0]; ++z[0]) visit(static_cast<const LatticePoint<d>&>(z));
    int axis = 1;
    for (; axis < d && z[axis] == box.hi[axis]; ++axis) z[axis] = box.lo[axis];
    if (axis == d) return;
    ++z[axis];
  }
}

/// Raster order: the last coordinate counts first.
template <int d>
bool raster_less(const LatticePoint<d>& a, const LatticePoint<d>& b) {
  for (int k = d - 1; k > 0; --k)
    if (a[k] != b[k]) return a[k] < b[k];
  return a[0] < b[0];
}

}  // namespace gridstep
