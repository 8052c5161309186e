#pragma once

#include "estimators/integral_invariant/radial/weight_tables.hpp"

namespace gridstep {

/// Adds the sums over the points of a mixed brick, at an offset that meets the ball.
using AddBrick = void (*)(const WeightTables& tables, const LatticePoint<3>& offset,
                          const std::uint64_t* words, RadialSum& sum);

/// The one for bricks::target().
AddBrick add_brick();

}  // namespace gridstep
