#pragma once

#include <cstdint>
#include <string>

#include "estimators/catalogue.hpp"
#include "shapes/digital/digital_set.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

/// What the memory of a digital set and of estimators on its boundary depends on.
struct SetSize {
  double surfels, bytes;
};

/// Of a scene, its surfels to within a factor of about two: a coarser digitization, which takes milliseconds, is made,
/// and the boundary taken to grow like h^-(d-1). Parts too thin for it are missed, unless nothing else is there:
/// then it is the boundary of the bounding box. Turned shapes count as if they were not.
/// @throws InputError "name: ..." as digital_bounds().
template <int d>
SetSize predicted_size(const std::string& name, const Shape<d>& shape, const SceneSettings<d>& settings);
template <int d>
SetSize size_of(const DigitalSet<d>& set);

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
