#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/analysis.hpp"

namespace gridstep {

/// The radii R = k h^alpha that a study tried with one estimator, alike in all but k, at one step.
struct RadiusScan : Setting {  ///< k is the best one
  std::string quantity, norm;
  double h;
  /// Mean error over the shifts at each k, by k.
  std::vector<std::pair<double, double>> errors;
  double least_error;
};

/// One entry for each series that comes with several k, at its coarsest and at its finest step, in the order of the series.
std::vector<RadiusScan> radius_scans_of(const std::vector<Convergence>& series);

/// One row a scan: the best k, its error, and the errors at every k. A best k at either end of those tried is marked: "<",
/// ">": the optimum may lie beyond.
Table best_radius_table(const std::vector<RadiusScan>& scans);

}  // namespace gridstep
