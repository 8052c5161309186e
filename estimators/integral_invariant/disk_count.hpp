#pragma once

#include <cstdint>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// The rows of the digital disk {z : |z| <= R/h}: the points of ball_kernel<2>(), as half-widths.
class DiskRows {
 public:
  /// @throws InputError where R/h < 1 or is not finite, or above 2^14.
  explicit DiskRows(DigitalLength radius);

  int reach() const { return int(half_width_.size()) - 1; }
  /// Row y, -reach() <= y <= reach(), holds x = -half_width(y) to half_width(y).
  int half_width(int y) const { return half_width_[std::size_t(y < 0 ? -y : y)]; }

 private:
  std::vector<int> half_width_;
};

/// Number of points of the set in the disk around a digital point: the sum that `ii` takes with that radius,
/// for radii that change from point to point. Cost O(R/h + the mixed bricks of the disk), by popcounts of rows;
/// reads whole bricks where they are full or empty.
std::int64_t count_in_disk(const DigitalSet<2>& set, const LatticePoint<2>& centre, const DiskRows& disk);

}  // namespace gridstep
