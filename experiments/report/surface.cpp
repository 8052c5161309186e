#include "experiments/report/surface.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "experiments/compared.hpp"
#include "experiments/memory.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

bool can_be_shown(const Record& record) {
  return record.dimension == 3 && !record.rotated && record.noise == 0 && record.shift == 0 &&
         record.surfels <= most_surfels_shown;
}

SceneSettings<3> settings_of(const Record& record) {
  if (!(record.h > 0 && std::isfinite(record.h)) || record.offset.size() != 3)
    throw InputError(fmt::format("h = {} with an offset of {} numbers is no digitization in 3D", record.h,
                                 record.offset.size()));
  SceneSettings<3> settings;
  settings.h = {record.h};
  for (int k = 0; k < 3; ++k) settings.placement.shift[k] = record.offset[std::size_t(k)];
  return settings;
}

EuclideanLength radius_of(const Record& record) {
  return record.takes_radius() ? RadiusRule{record.k, record.alpha}.at({record.h}) : EuclideanLength{0};
}

/// What wrong records ask for may be far too much.
void require_memory_for(const Record& record, SetSize size) {
  const DigitalLength radius{std::max(1.0, to_digital(radius_of(record), {record.h}).value)};
  const int threads = tbb::this_task_arena::max_concurrency();
  require_memory(size.bytes + size.surfels * predicted_surfel_memory(true) +
                     predicted_table_memory<3>(find_estimator(record.estimator).variant<3>(), radius,
                                               Evaluation::bricks, threads),
                 record.estimator);
}

Estimates estimates_of(const Record& record, const Scene<3>& scene) {
  const KernelCentre centre =
      record.takes_radius() ? parse_kernel_centre(record.centre) : KernelCentre::spels;
  // All evaluations give the same values: this is the fastest one.
  const auto estimator =
      find_estimator(record.estimator).variant<3>().make(scene.set, {Evaluation::bricks, centre});
  estimator->init({record.h}, radius_of(record));
  return estimator->eval(scene.surfels);
}

/// Those that are compared and are one number.
std::vector<std::string> scalar_quantities(const std::string& estimator) {
  std::vector<std::string> names;
  for (const Compared& compared : compared_quantities(estimator, 3))
    if (compared.columns.size() == 1) names.push_back(compared.name);
  return names;
}

/// To more digits than another compiler or processor changes.
bool same(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

void require_same_errors(const Record& record, const Compared& compared, const Estimates& estimates,
                         const Truth& truth) {
  const ErrorNorms now = error_norms(known_only(errors_of(compared, estimates, truth), truth));
  for (const auto& [quantity, then] : record.errors)
    if (quantity == compared.name && !(same(now.sup, then.sup) && same(now.rms, then.rms)))
      throw InputError(fmt::format("{}: the rms error of {} was {:.6g}, and is {:.6g} with this program",
                                   record.estimator, quantity, then.rms, now.rms));
}

}  // namespace

std::vector<std::vector<const Record*>> records_of_surfaces(const std::vector<Record>& records) {
  std::vector<std::vector<const Record*>> surfaces;
  for (const Record& record : records) {
    if (!can_be_shown(record)) continue;
    auto surface = std::find_if(surfaces.begin(), surfaces.end(), [&](const auto& candidate) {
      return candidate.front()->shape == record.shape;
    });
    if (surface == surfaces.end()) surface = surfaces.insert(surface, {&record});
    if (record.h < surface->front()->h) *surface = {&record};
    const bool is_new = std::none_of(surface->begin(), surface->end(), [&](const Record* other) {
      return other->estimator == record.estimator;
    });
    if (is_new && record.h == surface->front()->h) surface->push_back(&record);
  }
  return surfaces;
}

RecordedSurface remake_surface(const std::vector<const Record*>& records) {
  const Record& first = *records.front();
  const std::string what = fmt::format("{} at h = {:.6g}", first.shape, first.h);
  try {
    const auto shape = make_shape<3>(first.shape);
    const SceneSettings<3> settings = settings_of(first);
    const SetSize size = predicted_size(first.shape, *shape, settings);
    for (const Record* record : records) require_memory_for(*record, size);
    Scene<3> scene = make_scene<3>(*shape, settings);
    if (std::int64_t(scene.surfels.size()) != first.surfels)
      throw InputError(
          fmt::format("had {} surfels, and has {} with this program", first.surfels, scene.surfels.size()));

    RecordedSurface surface;
    surface.records = records;
    std::vector<std::string> columns;
    for (const Record* record : records) {
      surface.estimates.push_back(estimates_of(*record, scene));
      surface.quantities.push_back(scalar_quantities(record->estimator));
      for (const std::string& quantity : surface.quantities.back())
        if (std::find(columns.begin(), columns.end(), quantity) == columns.end()) columns.push_back(quantity);
    }
    surface.truth = truth_at_surfels<3>(*shape, settings, scene.surfels, columns);
    for (std::size_t i = 0; i < records.size(); ++i)
      for (const Compared& compared : compared_quantities(records[i]->estimator, 3))
        if (compared.columns.size() == 1)
          require_same_errors(*records[i], compared, surface.estimates[i], surface.truth);
    surface.surfels = std::move(scene.surfels);
    return surface;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", what, error.what()));
  }
}

}  // namespace gridstep
