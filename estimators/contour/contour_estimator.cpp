#include "estimators/contour/contour_estimator.hpp"

#include <cmath>

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

class ContourEstimator final : public Estimator<2> {
 public:
  ContourEstimator(std::vector<std::string> quantities, ContourFunction function)
      : quantities_(std::move(quantities)), function_(function) {}

  void init(GridStep h, EuclideanLength) override {
    expects(h.value > 0 && std::isfinite(h.value), "a positive grid step");
    h_ = h;
  }

  Estimates eval(std::span<const Surfel<2>> linels) override {
    expects(h_.value > 0, "init() before eval()");
    Estimates result{quantities_, std::vector<std::vector<double>>(quantities_.size())};
    for (const DigitalContour& contour : closed_contours(linels)) {
      std::vector<std::vector<double>> columns(quantities_.size(),
                                               std::vector<double>(contour.pointels.size()));
      function_(contour, h_, columns);
      for (std::size_t q = 0; q < columns.size(); ++q)
        result.columns[q].insert(result.columns[q].end(), columns[q].begin(), columns[q].end());
    }
    work_.evaluations = std::int64_t(linels.size());
    return result;
  }

  Estimates raw() const override { return {}; }
  EstimatorWork work() const override { return work_; }

 private:
  std::vector<std::string> quantities_;
  ContourFunction function_;
  GridStep h_{};
  EstimatorWork work_;
};

}  // namespace

EstimatorEntry contour_estimator(std::string name, std::string summary, std::vector<Quantity> quantities,
                                 ValuePosition position, ContourFunction function) {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities) names.push_back(quantity.name);
  EstimatorEntry::Variant<2> variant;
  variant.quantities = std::move(quantities);
  variant.make = [names, function](const DigitalSet<2>&, const EstimatorOptions&) {
    return std::make_unique<ContourEstimator>(names, function);
  };
  variant.position = position;
  variant.takes_radius = false;
  variant.evaluations = {};
  variant.centres = {};
  return {std::move(name), std::move(summary), std::move(variant), std::nullopt};
}

}  // namespace gridstep
