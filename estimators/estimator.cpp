#include "estimators/estimator.hpp"

#include <algorithm>
#include <utility>

#include "shapes/base/contracts.hpp"

namespace gridstep {

Estimates Estimates::zeros(std::vector<std::string> quantities, std::size_t rows) {
  const std::size_t columns = quantities.size();
  return {std::move(quantities), std::vector(columns, std::vector<double>(rows))};
}

const std::vector<double>& Estimates::operator[](const std::string& quantity) const {
  const auto found = std::find(quantities.begin(), quantities.end(), quantity);
  expects(found != quantities.end(), "a quantity of this estimator");
  return columns[std::size_t(found - quantities.begin())];
}

EstimatorWork& EstimatorWork::operator+=(const EstimatorWork& other) {
  evaluations += other.evaluations;
  cells_visited += other.cells_visited;
  restarts += other.restarts;
  kernel_size = other.kernel_size;
  mask_sizes = other.mask_sizes;
  fallbacks += other.fallbacks;
  return *this;
}

}  // namespace gridstep
