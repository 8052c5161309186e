#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>

#include "shapes/base/lattice.hpp"

namespace gridstep {

template <int d>
using RealBox = Eigen::AlignedBox<double, d>;

/// Where a box lies with respect to a region. `crossing` also stands for "not decided".
enum class Side { inside, outside, crossing };

/// A closed bounded region of R^d, as far as digitization needs to know it. Thread-safe: all members are
/// const.
template <int d>
class Region {
 public:
  virtual ~Region() = default;

  /// A box that contains the region.
  virtual RealBox<d> bounds() const = 0;

  /// Conservative: `inside` (`outside`) only where inside() is true (false) at every double point of the box.
  virtual Side side(const RealBox<d>& box) const = 0;

  /// Closed membership of up to 64 points; bit i belongs to points[i].
  virtual std::uint64_t inside(std::span<const RealPoint<d>> points) const = 0;

  bool contains(const RealPoint<d>& point) const { return inside({&point, 1}) != 0; }
};

}  // namespace gridstep
