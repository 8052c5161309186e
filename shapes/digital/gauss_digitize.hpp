#pragma once

#include "shapes/base/region.hpp"
#include "shapes/base/units.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// What a digitization cost, in calls to the region.
struct DigitizationWork {
  std::int64_t points = 0;  ///< points whose membership was computed
  std::int64_t boxes = 0;   ///< boxes over which the region was bounded
};

/// The digital points that can lie in a region at step h.
/// @throws InputError where coordinates would not fit 30 bits.
template <int d>
LatticeBox<d> digital_bounds(const Region<d>& region, GridStep h);

/// Gauss digitization: the points z of Z^d with h z in the region (closed).
///
/// Recurses on boxes down to those where the error of Region::bound is a tenth of a cell or leaves few points open;
/// only these are sampled. Equal, bit for bit, to sampling every point; O(h^-(d-1)) calls where the error of the bounds
/// shrinks with the square of the box, less than one a surfel at fine steps where it shrinks with the cube. Runs on all
/// threads of the current arena; the result does not depend on their number, nor on the processor.
template <int d>
DigitalSet<d> gauss_digitize(const Region<d>& region, GridStep h, DigitizationWork* work = nullptr);

}  // namespace gridstep
