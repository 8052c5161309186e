#include <cmath>

#include "estimators/catalogue.hpp"
#include "estimators/integral_invariant/curvature.hpp"
#include "estimators/integral_invariant/surfel_sums.hpp"

namespace gridstep {

namespace {

/// Curvature (2D) or mean curvature (3D) from the measure h^d n of the digital set in the ball.
///   Units  1/length, positive where the set is convex.
///   Bound  sup error O(h^1/3) with R = k h^1/3 for convex shapes with C^3 boundary [Coeurjolly, Lachaud, Levallois,
///          CVIU 2014, theorems 1 and 2].
///   Cost   see Evaluation.
template <int d>
class IntegralInvariant final : public Estimator<d> {
 public:
  IntegralInvariant(const DigitalSet<d>& set, const EstimatorOptions& options) : sums_(set, options) {}

  void init(GridStep h, EuclideanLength R) override {
    h_ = h;
    R_ = R;
    sums_.init(h, R);
  }

  Estimates eval(std::span<const Surfel<d>> surfels) override {
    raw_ = Estimates::zeros({"sum"}, surfels.size());
    Estimates result = Estimates::zeros({d == 2 ? "kappa" : "mean"}, surfels.size());
    const double cell = std::pow(h_.value, d);
    sums_.eval(surfels, [&](std::size_t i, const auto& inner, const auto& outer) {
      const double sum = 0.5 * double(inner.n + outer.n);
      raw_.columns[0][i] = sum;
      result.columns[0][i] =
          d == 2 ? curvature_from_area(cell * sum, R_) : mean_curvature_from_volume(cell * sum, R_);
    });
    return result;
  }

  Estimates raw() const override { return raw_; }
  EstimatorWork work() const override { return sums_.work(); }

 private:
  SurfelSums<d, PlainSum<d, std::int64_t>> sums_;
  GridStep h_{};
  EuclideanLength R_{};
  Estimates raw_;
};

template <int d>
EstimatorEntry::Variant<d> variant(const char* quantity) {
  return {{{quantity, 1.0 / 3.0}}, [](const DigitalSet<d>& set, const EstimatorOptions& options) {
            return std::make_unique<IntegralInvariant<d>>(set, options);
          }};
}

}  // namespace

EstimatorEntry describe_ii() {
  return {"ii", "integral invariant: curvature (2D), mean curvature (3D) from area or volume in a ball",
          variant<2>("kappa"), variant<3>("mean")};
}

}  // namespace gridstep
