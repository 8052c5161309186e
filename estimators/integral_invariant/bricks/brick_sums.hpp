#pragma once

#include <cstdint>

#include "estimators/integral_invariant/bricks/exact_sums.hpp"
#include "shapes/digital/brick.hpp"

namespace gridstep::bricks {

/// Adds the points of a brick whose lowest cell is at `origin`.
template <int d>
void add_brick(Counts<d>& sum, const Brick<d>& brick, const LatticePoint<d>&) {
  sum.n += std::uint64_t(brick.count());
}
void add_brick(Moments& sum, const Brick<3>& brick, const LatticePoint<3>& origin);

}  // namespace gridstep::bricks
