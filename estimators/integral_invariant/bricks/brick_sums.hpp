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
template <int d>
void add_brick(Moments<d>& sum, const Brick<d>& brick, const LatticePoint<d>& origin);

extern template void add_brick(Moments<2>&, const Brick<2>&, const LatticePoint<2>&);
extern template void add_brick(Moments<3>&, const Brick<3>&, const LatticePoint<3>&);

}  // namespace gridstep::bricks
