#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "estimators/catalogue.hpp"
#include "experiments/core/schedule.hpp"
#include "shapes/analytic/catalogue.hpp"

namespace gridstep {

/// One way to estimate.
struct Method {
  std::string estimator;
  std::optional<RadiusRule> radius;      ///< where the estimator takes one
  std::optional<Evaluation> evaluation;  ///< where it takes options

  /// Whether both must give the same numbers: all but the evaluation is the same.
  bool agrees_with(const Method& other) const;
};

/// Every combination of what it lists, at every h of the schedule, under `shifts` random placements each.
struct Sweep {
  std::vector<ShapeSpec> shapes;  ///< of one dimension
  std::vector<std::string> estimators;
  std::vector<Evaluation> evaluations;  ///< the first one gives the errors; all are timed, and must agree
  std::vector<RadiusRule> radii;        ///< R(h) = k h^alpha; none: the usual one of each estimator
  std::vector<double> noise;            ///< beta of Kanungo noise, 0 for none
  KernelCentre centre = KernelCentre::spels;
  Schedule schedule;
  int shifts = 10;
  bool rotate = false;  ///< a random rotation beside each random shift

  int dimension() const;
  /// What is done on each digitization, in order: radii, estimators, evaluations. Estimators that take no
  /// radius come once, with the first one.
  std::vector<Method> methods() const;
};

/// What to compute; with a seed, it decides every number but the timings.
struct Study {
  std::string name, description;
  std::uint64_t seed = 1;
  bool timing = false;  ///< evaluations on one thread and repeated, for times that can be compared
  std::vector<std::string> tables;  ///< to print: convergence, cost, work-precision, equal-error, best-radius, noise, isotropy
  std::vector<Sweep> sweeps;

  /// From JSON as documented in results/README.md. Everything is checked here: names, parameters, R/h >= 1 at
  /// every h.
  /// @throws InputError naming the source, the place, the key and the value.
  static Study read(const nlohmann::json& json, const std::string& source);
};

}  // namespace gridstep
