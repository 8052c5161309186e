#pragma once

#include <compare>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "estimators/estimator.hpp"
#include "experiments/core/norms.hpp"

namespace gridstep {

/// What stays the same along a schedule: errors at several h make a curve where these are equal.
struct Setting {
  std::string shape;
  int dimension = 2;
  double noise = 0;
  bool rotated = false;  ///< a random rotation beside each shift
  std::string estimator, centre;
  double k = 0, alpha = 0;  ///< R = k h^alpha; both 0 where the estimator takes no radius

  bool takes_radius() const { return k > 0; }
  auto operator<=>(const Setting&) const = default;
};

/// What one estimator did on one digitization: a line of records.jsonl. Fields are documented in
/// results/README.md.
struct Record : Setting {
  std::string evaluation;  ///< empty where the estimator has but one way
  double h = 0;
  int shift = 0;               ///< number of the placement
  std::vector<double> offset;  ///< its sub-grid shift, in cells
  double digital_radius = 0;   ///< R/h; 0 without a radius
  std::int64_t surfels = 0;    ///< all, of which `singular` and `far` have no truth
  std::int64_t singular = 0, far = 0, components = 0;
  double worst_residual = 0;                               ///< of the truth, relative to the shape's size
  std::vector<std::pair<std::string, ErrorNorms>> errors;  ///< by quantity; none where no surfel has a truth
  EstimatorWork work;
  double seconds_digitize = 0, seconds_truth = 0, seconds_init = 0, seconds_eval = 0;
};

/// Its fields by name; null for the radius and the centre where there is no radius.
nlohmann::ordered_json setting_json(const Setting& setting);
nlohmann::ordered_json to_json(const ErrorNorms& norms);
nlohmann::ordered_json to_json(const EstimatorWork& work);
nlohmann::ordered_json to_json(const Record& record);
/// @throws InputError where a field is missing or of the wrong type.
Record record_from(const nlohmann::ordered_json& json);

}  // namespace gridstep
