#pragma once

#include <span>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// Where the value that an estimator gives for a surfel belongs, and where it is compared with the truth: at
/// the centre of the surfel, or in 2D at the pointel at which the linel starts, walking with the set on the
/// left.
enum class ValuePosition { surfel_centre, start_pointel };

/// The positions in the unit of the shape, one a surfel.
/// @throws ContractViolation for start_pointel in 3D.
template <int d>
std::vector<RealPoint<d>> value_points(ValuePosition position, std::span<const Surfel<d>> surfels,
                                       GridStep h);

/// How far such a position may be from the boundary of a Gauss-digitized shape. The boundary passes between
/// the inner and the outer point of a surfel, h apart, and the end of a linel is another h/2 away; the slack
/// is for rounding.
constexpr EuclideanLength farthest_from_boundary(ValuePosition position, GridStep h) {
  return {(position == ValuePosition::surfel_centre ? 0.5 : 1.0) * h.value * (1 + 1e-9)};
}

}  // namespace gridstep
