#pragma once

#include <cstdint>
#include <string>

#include "estimators/catalogue.hpp"
#include "shapes/base/region.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// What a digitization and an estimator will hold, to within a factor of about two: the boundary is taken to have as many
/// surfels as that of the bounding box.
template <int d>
double predicted_surfels(const RealBox<d>& bounds, GridStep h);

/// Bytes of the digital set.
template <int d>
double predicted_set_memory(const RealBox<d>& bounds, GridStep h);

/// Bytes of a surfel at hand: its place, its spels and their sums, its columns of estimates and of truth.
double predicted_surfel_memory(bool moments);

/// Bytes of an estimator's kernel, masks or tables, and of the windows of its threads.
template <int d>
double predicted_table_memory(const EstimatorEntry::Variant<d>& variant, DigitalLength radius,
                              Evaluation evaluation, int threads);

/// The most bytes that this process has held at a time.
double peak_memory();

/// "peak memory 1.2 GiB (18.1 bytes a surfel), predicted 2 GiB".
std::string memory_report(double predicted, std::int64_t surfels);

/// @throws InputError "what: needs about ... GiB, but only ... GiB are available".
void require_memory(double bytes, const std::string& what);

}  // namespace gridstep
