#include <gtest/gtest.h>

#include <cmath>

#include "estimators/catalogue.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/scene.hpp"

namespace gridstep {
namespace {

template <int d>
Scene<d> scene_of(const Shape<d>& shape, GridStep h) {
  SceneSettings<d> settings;
  settings.h = h;
  return make_scene<d>(shape, settings);
}

/// The surfel with given Khalimsky coordinates.
template <int d>
std::size_t find_surfel(const std::vector<Surfel<d>>& surfels, const LatticePoint<d>& coordinates) {
  const auto found = std::find_if(surfels.begin(), surfels.end(),
                                  [&](const auto& s) { return s.cell().coordinates == coordinates; });
  if (found == surfels.end()) throw InputError("no such surfel");
  return std::size_t(found - surfels.begin());
}

template <int d>
struct Evaluated {
  std::vector<Surfel<d>> surfels;
  Estimates estimates, raw;
  EstimatorWork work;
};

template <int d>
Evaluated<d> evaluate(const std::string& estimator, const std::string& shape, GridStep h, EuclideanLength R,
                      Evaluation evaluation) {
  const Scene<d> scene = scene_of<d>(*make_shape<d>(shape), h);
  const auto made = find_estimator(estimator).variant<d>().make(scene.set, {evaluation, KernelCentre::spels});
  made->init(h, R);
  Estimates estimates = made->eval(scene.surfels);
  return {scene.surfels, std::move(estimates), made->raw(), made->work()};
}

class IntegralInvariant : public testing::TestWithParam<Evaluation> {};

// Rows of dumps of DGtal 2.1.1 (commit 1574af90c): Khalimsky coordinates, count (mean of the two spels),
// estimates.

TEST_P(IntegralInvariant, AgreesWithDGtalInTwoDimensions) {
  struct Row {
    LatticePoint<2> k;
    double count, kappa;
  };
  const auto expect = [&](const std::string& shape, GridStep h, EuclideanLength R, std::size_t surfels,
                          std::int64_t kernel, const std::vector<Row>& rows) {
    const auto result = evaluate<2>("ii", shape, h, R, GetParam());
    EXPECT_EQ(result.surfels.size(), surfels);
    EXPECT_EQ(result.work.kernel_size, kernel);
    for (const Row& row : rows) {
      const std::size_t i = find_surfel<2>(result.surfels, row.k);
      EXPECT_EQ(result.raw["sum"][i], row.count) << row.k.transpose();
      EXPECT_NEAR(result.estimates["kappa"][i], row.kappa, 1e-12) << row.k.transpose();
    }
  };
  // R/h = 10: the ball is closed, and has all of its 317 points.
  expect("disk:radius=5", {0.1}, {1}, 404, 317,
         {{{88, -49}, 149, 0.24238898038468903},
          {{88, -47}, 159, -0.057611019615311232},
          {{56, 85}, 147.5, 0.28738898038468874},
          {{-82, 57}, 150, 0.21238898038468901}});
  expect("flower:radius=20,amplitude=10,petals=6,phase=3", {0.1}, RadiusRule{3}.at({0.1}), 3572, 601,
         {{{257, -258}, 300.5, 0.045289208532695004},
          {{333, -62}, 306.5, -0.021377458133971225},
          {{382, 333}, 293.5, 0.12306698631047309},
          {{-101, 476}, 295, 0.10640031964380629}});
}

TEST_P(IntegralInvariant, AgreesWithDGtalInThreeDimensions) {
  struct Row {
    LatticePoint<3> k;
    double count, mean, xx, xy, xz, yy, yz, zz, k1, k2;
  };
  const auto expect = [&](const std::string& shape, GridStep h, EuclideanLength R, std::size_t surfels,
                          std::int64_t kernel, const std::vector<Row>& rows) {
    const auto mean = evaluate<3>("ii", shape, h, R, GetParam());
    const auto all = evaluate<3>("ii-covariance", shape, h, R, GetParam());
    EXPECT_EQ(mean.surfels.size(), surfels);
    EXPECT_EQ(mean.work.kernel_size, kernel);
    for (const Row& row : rows) {
      const std::size_t i = find_surfel<3>(mean.surfels, row.k);
      EXPECT_EQ(mean.raw["sum"][i], row.count);
      EXPECT_EQ(all.raw["sum"][i], row.count);
      EXPECT_NEAR(mean.estimates["mean"][i], row.mean, 1e-9);
      const double scale = 1e-12 * (row.xx + row.yy + row.zz);
      EXPECT_NEAR(all.raw["cov_xx"][i], row.xx, scale);
      EXPECT_NEAR(all.raw["cov_xy"][i], row.xy, scale);
      EXPECT_NEAR(all.raw["cov_xz"][i], row.xz, scale);
      EXPECT_NEAR(all.raw["cov_yy"][i], row.yy, scale);
      EXPECT_NEAR(all.raw["cov_yz"][i], row.yz, scale);
      EXPECT_NEAR(all.raw["cov_zz"][i], row.zz, scale);
      EXPECT_NEAR(all.estimates["k1"][i], row.k1, 1e-9);
      EXPECT_NEAR(all.estimates["k2"][i], row.k2, 1e-9);
    }
  };
  expect("sphere:radius=5", {0.5}, RadiusRule{3}.at({0.5}), 1902, 461,
         {{{15, -10, -9},
           174,
           0.2584250478,
           428.34350660204,
           177.72396790908,
           163.83687113488,
           525.17716864449,
           -120.72605716196,
           550.20942670901,
           0.24278006,
           0.2345042535},
          {{-11, -15, 0},
           186.5,
           0.196535337,
           526.50040253019,
           -240.05301897642,
           -18.981081081081,
           389.32264232317,
           -18.491891891892,
           737.38918918919,
           0.2193835847,
           0.1772958276}});
  expect("torus:major=6,minor=2", {0.5}, RadiusRule{2}.at({0.5}), 2584, 147,
         {{{27, -18, 3},
           53,
           0.3514320908,
           57.2892228739,
           36.961876832845,
           -9.8771994134897,
           77.955278592375,
           10.66568914956,
           74.298020527859,
           0.5284945445,
           0.1111669769},
          {{20, 3, -5},
           64.5,
           0.06318076279,
           84.843444227006,
           -15.608610567515,
           -25.05675146771,
           155.27152641879,
           -2.8581213307241,
           58.866927592955,
           0.5061272705,
           -0.4027975226}});
}

/// The mean curvature of Goursat's surface where Newton steps along the gradient lead from a point: near the
/// closest point of the surface, but not it.
double goursat_mean_along_gradient(RealPoint<3> p) {
  const auto gradient = [&] { return RealPoint<3>(0.12 * p.array().cube().matrix() - 4 * p); };
  for (int i = 0; i < 30; ++i) {
    const RealPoint<3> g = gradient();
    p -= (0.03 * p.array().pow(4).sum() - 2 * p.squaredNorm() - 8) / g.squaredNorm() * g;
  }
  const RealPoint<3> g = gradient(), hessian = 0.36 * p.array().square() - 4;
  return (hessian.sum() * g.squaredNorm() - hessian.dot(g.cwiseAbs2())) / (2 * std::pow(g.norm(), 3));
}

struct Errors {
  double sup = 0, rms = 0;
};

Errors errors_of(const std::vector<double>& estimates, const std::vector<double>& truth) {
  Errors errors;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const double error = std::abs(estimates[i] - truth[i]);
    errors.sup = std::max(errors.sup, error);
    errors.rms += error * error / double(estimates.size());
  }
  errors.rms = std::sqrt(errors.rms);
  return errors;
}

/// Errors of H on Goursat's surface with R = 3 h^0.33, no shift. The published figures take the truth along
/// the gradient; those at the closest point are ours, and differ in the fourth digit of sup at the coarser
/// step.
void expect_goursat(double h, std::size_t surfels, const Errors& published, const Errors& at_closest,
                    Evaluation evaluation) {
  const auto shape = make_shape<3>("goursat");
  const Scene<3> scene = scene_of<3>(*shape, {h});
  ASSERT_EQ(scene.surfels.size(), surfels);
  const Truth truth = truth_at_surfels<3>(*shape, scene.settings, scene.surfels, {"mean"});
  ASSERT_EQ(truth.singular, 0);
  std::vector<double> along_gradient;
  for (const Surfel<3>& surfel : scene.surfels)
    along_gradient.push_back(goursat_mean_along_gradient(centre(surfel, h)));
  const auto estimator = find_estimator("ii").variant<3>().make(scene.set, {evaluation, KernelCentre::spels});
  estimator->init({h}, RadiusRule{3, 0.33}.at({h}));
  const Estimates estimates = estimator->eval(scene.surfels);
  const Errors theirs = errors_of(estimates["mean"], along_gradient);
  const Errors ours = errors_of(estimates["mean"], truth.columns[0]);
  EXPECT_NEAR(theirs.sup, published.sup, 0.00005);
  EXPECT_NEAR(theirs.rms, published.rms, 0.000005);
  EXPECT_NEAR(ours.sup, at_closest.sup, 0.00005);
  EXPECT_NEAR(ours.rms, at_closest.rms, 0.000005);
}

TEST_P(IntegralInvariant, HasThePublishedErrorsOnGoursatsSurface) {
  expect_goursat(0.5, 9510, {0.2121, 0.08354}, {0.2119, 0.08354}, GetParam());
}

TEST(IntegralInvariantAtAFineStep, HasThePublishedErrorsOnGoursatsSurface) {
  expect_goursat(0.125, 151374, {0.1246, 0.05470}, {0.1246, 0.05470}, Evaluation::masks);
}

INSTANTIATE_TEST_SUITE_P(Evaluations, IntegralInvariant, testing::Values(Evaluation::full, Evaluation::masks),
                         [](const auto& tested) { return to_string(tested.param); });

}  // namespace
}  // namespace gridstep
