#include "experiments/compared.hpp"

#include <algorithm>
#include <cmath>

#include "shapes/base/contracts.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

const std::vector<double>& column(const Truth& truth, const std::string& name) {
  const auto found = std::find(truth.quantities.begin(), truth.quantities.end(), name);
  expects(found != truth.quantities.end(), "the truth of a compared quantity");
  return truth.columns[std::size_t(found - truth.quantities.begin())];
}

}  // namespace

template <int d>
std::vector<Compared> compared_quantities(const EstimatorEntry::Variant<d>& variant) {
  std::vector<Compared> result;
  for (const Quantity& quantity : variant.quantities) {
    const std::size_t stem = quantity.name.find('_');
    if (stem == std::string::npos) {
      result.push_back({quantity.name, {quantity.name}, quantity.proven_rate});
      continue;
    }
    const std::string name = quantity.name.substr(0, stem);
    if (name != "tangent" && name != "normal") continue;
    if (result.empty() || result.back().name != name) result.push_back({name, {}, quantity.proven_rate});
    result.back().columns.push_back(quantity.name);
  }
  return result;
}

template std::vector<Compared> compared_quantities(const EstimatorEntry::Variant<2>&);
template std::vector<Compared> compared_quantities(const EstimatorEntry::Variant<3>&);

std::vector<Compared> compared_quantities(const std::string& estimator, int dimension) {
  for (const EstimatorEntry& entry : estimator_catalogue()) {
    if (entry.name != estimator) continue;
    if (dimension == 2 && entry.in_2d) return compared_quantities(*entry.in_2d);
    if (dimension == 3 && entry.in_3d) return compared_quantities(*entry.in_3d);
  }
  return {};
}

std::vector<double> errors_of(const Compared& compared, const Estimates& estimates, const Truth& truth) {
  std::vector<const std::vector<double>*> estimated, exact;
  for (const std::string& name : compared.columns) {
    estimated.push_back(&estimates[name]);
    exact.push_back(&column(truth, name));
  }
  const auto error_at = [&](std::size_t i) {
    if (compared.columns.size() == 1) return (*estimated[0])[i] - (*exact[0])[i];
    // Of unit vectors a and b: 2 atan2(|a - b|, |a + b|), exact for small angles too [Kahan].
    double difference = 0, sum = 0;
    for (std::size_t k = 0; k < estimated.size(); ++k) {
      const double a = (*estimated[k])[i], b = (*exact[k])[i];
      difference += (a - b) * (a - b);
      sum += (a + b) * (a + b);
    }
    return 2 * std::atan2(std::sqrt(difference), std::sqrt(sum));
  };
  std::vector<double> errors(truth.known.size(), 0.0);
  constexpr std::size_t kGrain = 1024;
  parallel_chunks(errors.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i)
      if (truth.known[i]) errors[i] = error_at(i);
  });
  return errors;
}

std::vector<double> known_only(std::vector<double> errors, const Truth& truth) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (truth.known[i]) errors[kept++] = errors[i];
  errors.resize(kept);
  return errors;
}

}  // namespace gridstep
