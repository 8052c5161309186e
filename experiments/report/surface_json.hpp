#pragma once

#include <nlohmann/json_fwd.hpp>

#include "experiments/report/detail_surface.hpp"
#include "experiments/report/surface.hpp"

namespace gridstep {

/// What there is to choose from and to say: shape, h, offset, surfels; of each estimator its radius and
/// quantities, whether it has principal directions, and its errors.
nlohmann::ordered_json surface_description(const RecordedSurface& surface);
/// The same of radii, which are to be shown all at once: `side_by_side`. Without errors.
nlohmann::ordered_json surface_description(const DetailSurface& surface);

/// The numbers themselves, each list as base64 of little-endian values:
///   cells      3 x uint16 a surfel: Khalimsky coordinates less an even `origin`, so that the even one still tells
///              the axis of the normal
///   signs      int8: +1 where the normal points up the axis, -1 down
///   truth      by quantity, float32; NaN at surfels without one
///   estimates  one entry an estimator or radius: by quantity, float32
///   directions one entry each: 6 x int8, the directions of k1 and of k2 times 127; null without them
nlohmann::ordered_json surface_arrays(const Surface& surface);

}  // namespace gridstep
