#include "experiments/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "shapes/base/contracts.hpp"

namespace gridstep {

Distribution distribution_of(std::vector<double> values) {
  expects(!values.empty(), "at least one value");
  std::sort(values.begin(), values.end());
  Distribution result;
  for (const double p : Distribution::kProbabilities) {
    const double place = p * double(values.size() - 1);
    const std::size_t below = std::size_t(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    result.quantiles.push_back(std::lerp(values[below], values[above], place - double(below)));
  }
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  return result;
}

nlohmann::ordered_json to_json(const Distribution& distribution) {
  return {{"probabilities", Distribution::kProbabilities},
          {"quantiles", distribution.quantiles},
          {"mean", distribution.mean}};
}

}  // namespace gridstep
