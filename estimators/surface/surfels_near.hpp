#pragma once

#include <span>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/digital_set.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// The surfels of the boundary that are within reach of some of them, in each direction, and more: those of whole
/// bricks. In the order of boundary(). Cost that of a scan of the whole boundary, memory that of the result.
std::vector<Surfel<3>> surfels_near(const DigitalSet<3>& set, std::span<const Surfel<3>> surfels,
                                    DigitalLength reach);

}  // namespace gridstep
