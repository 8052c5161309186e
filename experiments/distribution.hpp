#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace gridstep {

/// How the values of a quantity spread over a surface.
struct Distribution {
  /// Ends, the middle 98 and 90 of 100, quartiles and median.
  static constexpr double kProbabilities[] = {0, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 1};

  std::vector<double> quantiles;  ///< one a probability, interpolated linearly between the sorted values
  double mean = 0;
};

/// @throws ContractViolation where there is no value.
Distribution distribution_of(std::vector<double> values);

nlohmann::ordered_json to_json(const Distribution& distribution);

}  // namespace gridstep
