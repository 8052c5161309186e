#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>

#include "shapes/base/quadratic_bound.hpp"

namespace gridstep {

/// A closed bounded region of R^d, as far as digitization needs to know it. Thread-safe: all members are
/// const.
template <int d>
class Region {
 public:
  virtual ~Region() = default;

  /// A box that contains the region.
  virtual RealBox<d> bounds() const = 0;

  /// What is known of inside() over each of some boxes. Digitization calls for O(h^-(d-1)) points and boxes where the
  /// error shrinks at least with the square of the box; small enough boxes may stay undecided.
  /// @param boxes at most kMostBoxes
  /// @param bounds as many
  virtual void bound_each(std::span<const RealBox<d>> boxes, std::span<QuadraticBound<d>> bounds) const = 0;
  static constexpr std::size_t kMostBoxes = 8;

  QuadraticBound<d> bound(const RealBox<d>& box) const {
    QuadraticBound<d> result;
    bound_each({&box, 1}, {&result, 1});
    return result;
  }

  /// Conservative: `inside` (`outside`) only where inside() is true (false) at every double point of the box.
  Side side(const RealBox<d>& box) const { return bound(box).side(box); }

  /// Closed membership of up to 64 points; bit i belongs to points[i].
  virtual std::uint64_t inside(std::span<const RealPoint<d>> points) const = 0;

  bool contains(const RealPoint<d>& point) const { return inside({&point, 1}) != 0; }
};

}  // namespace gridstep
