#pragma once

#include <string>

#include "estimators/catalogue.hpp"
#include "shapes/base/region.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// Bytes that a digitization and one estimator will hold at the same time, to within a factor of about two:
/// the boundary is taken to have as many surfels as that of the bounding box.
template <int d>
double predicted_memory(const RealBox<d>& bounds, GridStep h, DigitalLength radius, bool moments,
                        Evaluation evaluation, int threads);

/// @throws InputError "what: needs about ... GiB, but only ... GiB are available".
void require_memory(double bytes, const std::string& what);

}  // namespace gridstep
