#include <algorithm>
#include <array>
#include <cmath>

#include "estimators/catalogue.hpp"
#include "estimators/contour/tangential_cover.hpp"
#include "estimators/integral_invariant/curvature.hpp"
#include "estimators/integral_invariant/disk_count.hpp"
#include "shapes/base/contracts.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

/// R = kScale h L^2 for maximal segments of mean length L. The theorem holds for any constant; this one gives
/// R = 5 h^1/3 or so on curves of radius 15, as studies of integral invariants take it.
constexpr double kScale = 0.1;

/// Curvature by integral invariants whose radius follows from the contour.
///   R(i) = kScale h L(i)^2, L(i) the mean number of linels of the maximal segments that contain linel i:
///   maximal segments grow like h^-1/3 on the average, so R like h^1/3. At least one cell, and at most a quarter of the
///   shorter side of the contour's bounding box: on straight parts the segments are as long as these.
///   Units   kappa in 1/length, positive where the set is convex. The kernel is centred on the two spels of the
///   linel, values averaged, as `ii` does by default.
///   Bound   none proven for the local radius; O(h^1/3) with L averaged over the whole contour.
///   Cost    O(R/h) rows a linel.
///   Source  [Levallois, Coeurjolly, Lachaud, Parameter-free and multigrid convergent digital curvature
///   estimators, DGCI 2014].
class ParameterFree final : public Estimator<2> {
 public:
  explicit ParameterFree(const DigitalSet<2>& set) : rows_(set) {}

  void init(GridStep h, EuclideanLength) override {
    expects(h.value > 0 && std::isfinite(h.value), "a positive grid step");
    h_ = h;
  }

  Estimates eval(std::span<const Surfel<2>> linels) override {
    expects(h_.value > 0, "init() before eval()");
    raw_ = Estimates::zeros({"digital_radius", "sum"}, linels.size());
    Estimates result = Estimates::zeros({"kappa"}, linels.size());
    std::size_t first = 0;
    for (const DigitalContour& contour : closed_contours(linels)) {
      const std::vector<double> radii = digital_radii(contour);
      parallel_chunks(radii.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) {
          const Surfel<2>& linel = linels[first + i];
          const DiskRows disk({radii[i]});
          const double sum = 0.5 * double(rows_.count(linel.inner, disk) + rows_.count(linel.outer(), disk));
          raw_.set_row(first + i, std::array{radii[i], sum});
          result.columns[0][first + i] =
              curvature_from_area(h_.value * h_.value * sum, {radii[i] * h_.value});
        }
      });
      first += radii.size();
    }
    work_.evaluations = 2 * std::int64_t(linels.size());
    return result;
  }

  Estimates raw() const override { return raw_; }
  EstimatorWork work() const override { return work_; }

 private:
  /// R/h for each linel.
  static std::vector<double> digital_radii(const DigitalContour& contour) {
    LatticePoint<2> lowest = contour[0], highest = contour[0];
    for (const LatticePoint<2>& p : contour.pointels) {
      lowest = lowest.cwiseMin(p);
      highest = highest.cwiseMax(p);
    }
    const double most = std::clamp(0.25 * (highest - lowest).minCoeff(), 1.0, 0x1p14);
    const TangentialCover cover(contour);
    std::vector<double> radii;
    for (const CyclicRange& segments : cover.segments_of_linels()) {
      double length = 0;
      for (std::ptrdiff_t k = segments.begin; k < segments.end; ++k)
        length += double(cover[k].last - cover[k].first);
      length /= double(segments.end - segments.begin);
      radii.push_back(std::clamp(kScale * length * length, 1.0, most));
    }
    return radii;
  }

  RowRuns rows_;
  GridStep h_{};
  Estimates raw_;
  EstimatorWork work_;
};

}  // namespace

EstimatorEntry describe_ii_parameter_free() {
  EstimatorEntry::Variant<2> variant;
  variant.quantities = {{"kappa", std::nullopt}};
  variant.make = [](const DigitalSet<2>& set, const EstimatorOptions&) {
    return std::make_unique<ParameterFree>(set);
  };
  variant.takes_radius = false;
  variant.evaluations = {};
  variant.centres = {};
  return {"ii-parameter-free", "integral invariant with a radius from the maximal segments: curvature (2D)",
          std::move(variant), std::nullopt};
}

}  // namespace gridstep
