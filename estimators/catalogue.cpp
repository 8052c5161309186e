#include "estimators/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "shapes/base/contracts.hpp"

namespace gridstep {

#define GRIDSTEP_ESTIMATOR(id) EstimatorEntry describe_##id();
#include "estimators/catalogue.inc"
#undef GRIDSTEP_ESTIMATOR

namespace {

void require_built(const EstimatorEntry& entry) {
  if (!entry.not_built.empty())
    throw InputError(fmt::format("estimator '{}' is not in this build: {}", entry.name, entry.not_built));
}

}  // namespace

template <>
const EstimatorEntry::Variant<2>& EstimatorEntry::variant<2>() const {
  if (!in_2d) throw InputError(fmt::format("estimator '{}' has no 2D form", name));
  require_built(*this);
  return *in_2d;
}

template <>
const EstimatorEntry::Variant<3>& EstimatorEntry::variant<3>() const {
  if (!in_3d) throw InputError(fmt::format("estimator '{}' has no 3D form", name));
  require_built(*this);
  return *in_3d;
}

template <int d>
void EstimatorVariant<d>::require(Evaluation evaluation, const std::string& estimator) const {
  if (std::find(evaluations.begin(), evaluations.end(), evaluation) != evaluations.end()) return;
  std::vector<std::string> known;
  for (const Evaluation one : evaluations) known.push_back(to_string(one));
  throw InputError(fmt::format("estimator '{}' has no evaluation '{}'; it has: {}", estimator,
                               to_string(evaluation), fmt::join(known, ", ")));
}

template <int d>
KernelCentre EstimatorVariant<d>::centre(KernelCentre wanted) const {
  return centres.size() == 1 ? centres.front() : wanted;
}

template struct EstimatorVariant<2>;
template struct EstimatorVariant<3>;

const std::vector<EstimatorEntry>& estimator_catalogue() {
  static const std::vector<EstimatorEntry> entries{
#define GRIDSTEP_ESTIMATOR(id) describe_##id(),
#include "estimators/catalogue.inc"
#undef GRIDSTEP_ESTIMATOR
  };
  return entries;
}

const EstimatorEntry& find_estimator(const std::string& name) {
  for (const EstimatorEntry& entry : estimator_catalogue())
    if (entry.name == name) return entry;
  std::string known;
  for (const EstimatorEntry& entry : estimator_catalogue()) known += (known.empty() ? "" : ", ") + entry.name;
  throw InputError(fmt::format("unknown estimator '{}'; known: {}", name, known));
}

}  // namespace gridstep
