#include <cmath>

#include "estimators/catalogue.hpp"
#include "estimators/integral_invariant/curvature.hpp"
#include "estimators/integral_invariant/surfel_sums.hpp"

namespace gridstep {

namespace {

/// All curvatures of a surface from the covariance of the digital set in the ball:
///   J = h^5 (sum pp' - (sum p)(sum p)' / n), p in cells, the mean over the surfel's two spels.
///   Units  1/length (gaussian: 1/length^2), positive where the set is convex; directions are unit vectors.
///   Bound  sup error of k1 and k2, and so of mean and gaussian, O(h^1/3) with R = k h^1/3 [Coeurjolly,
///   Lachaud, Levallois, CVIU 2014, theorem 3]. Cost   that of `ii` times a constant for ten sums in place of
///   one.
class IntegralInvariantCovariance final : public Estimator<3> {
 public:
  static constexpr std::array kRaw{"sum", "cov_xx", "cov_xy", "cov_xz", "cov_yy", "cov_yz", "cov_zz"};

  IntegralInvariantCovariance(const DigitalSet<3>& set, const EstimatorOptions& options)
      : sums_(set, options), centre_(options.centre) {}

  void init(GridStep h, EuclideanLength R) override {
    h_ = h;
    R_ = R;
    sums_.init(h, R);
  }

  Estimates eval(std::span<const Surfel<3>> surfels) override {
    Estimates result = Estimates::zeros({kSurfaceQuantities.begin(), kSurfaceQuantities.end()}, surfels.size());
    raw_ = Estimates::zeros({kRaw.begin(), kRaw.end()}, surfels.size());
    const double scale = std::pow(h_.value, 5);
    sums_.eval(surfels, [&](std::size_t i, const Sum& inner, const Sum& outer) {
      const Eigen::Matrix3d covariance = 0.5 * (covariance_of(inner) + covariance_of(outer));
      Eigen::Vector3d towards_inside = first_moment(inner) + first_moment(outer);
      // Both sums are taken from the lower spel here, half a cell off the centre of the ball.
      if (centre_ == KernelCentre::surfel) towards_inside[surfels[i].axis] -= double(inner.n);
      const PrincipalCurvatures principal = principal_curvatures(scale * covariance, towards_inside, R_);
      result.set_row(
          i, surface_values((principal.k1 + principal.k2) / 2, principal.k1 * principal.k2, principal));
      raw_.set_row(i, std::array{0.5 * double(inner.n + outer.n), covariance(0, 0), covariance(0, 1),
                                 covariance(0, 2), covariance(1, 1), covariance(1, 2), covariance(2, 2)});
    });
    return result;
  }

  Estimates raw() const override { return raw_; }
  EstimatorWork work() const override { return sums_.work(); }

 private:
  using Sum = MomentSums<3, std::int64_t>;

  static Eigen::Vector3d first_moment(const Sum& sum) {
    return {double(sum.first[0]), double(sum.first[1]), double(sum.first[2])};
  }
  static Eigen::Matrix3d covariance_of(const Sum& sum) {
    Eigen::Matrix3d result;
    for (int i = 0, pair = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j, ++pair)
        result(i, j) = result(j, i) =
            double(sum.second[std::size_t(pair)]) -
            double(sum.first[std::size_t(i)]) * double(sum.first[std::size_t(j)]) / double(sum.n);
    return result;
  }

  SurfelSums<3, Sum> sums_;
  KernelCentre centre_;
  GridStep h_{};
  EuclideanLength R_{};
  Estimates raw_;
};

}  // namespace

EstimatorEntry describe_ii_covariance() {
  EstimatorEntry::Variant<3> variant;
  for (const std::string quantity : kSurfaceQuantities) {
    const bool proven = quantity == "mean" || quantity == "gaussian" || quantity == "k1" || quantity == "k2";
    variant.quantities.push_back({quantity, proven ? std::optional(1.0 / 3.0) : std::nullopt});
  }
  variant.make = [](const DigitalSet<3>& set, const EstimatorOptions& options) {
    return std::make_unique<IntegralInvariantCovariance>(set, options);
  };
  return {
      "ii-covariance",
      "integral invariant: all curvatures, principal directions and the normal from the covariance in a ball",
      std::nullopt, std::move(variant)};
}

}  // namespace gridstep
