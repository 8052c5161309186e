#pragma once

#include <nlohmann/json_fwd.hpp>

#include "experiments/report/surface.hpp"

namespace gridstep {

/// What there is to choose from and to say: shape, h, offset, surfels; of each estimator its radius and
/// quantities, whether it has principal directions, and its errors.
nlohmann::ordered_json surface_description(const Surface& surface);

/// The numbers themselves, each list as base64 of little-endian values:
///   cells      3 x uint16 a surfel: Khalimsky coordinates less an even `origin`, so that the even one still tells
///              the axis of the normal
///   signs      int8: +1 where the normal points up the axis, -1 down
///   truth      by quantity, float32; NaN at surfels without one
///   estimates  one entry an estimator: by quantity, float32
///   directions one entry an estimator: 6 x int8, the directions of k1 and of k2 times 127; null without them
nlohmann::ordered_json surface_arrays(const Surface& surface);

}  // namespace gridstep
