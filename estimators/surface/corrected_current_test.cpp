#include "estimators/surface/corrected_current.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimators/surface/constant_current.hpp"
#include "estimators/surface/interpolated_current.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/scene.hpp"

namespace gridstep {
namespace {

struct Errors {
  double sup = 0, rms = 0;
};

Errors errors_on_goursat(const std::string& estimator, double h) {
  const auto shape = make_shape<3>("goursat");
  SceneSettings<3> settings;
  settings.h = {h};
  const Scene<3> scene = make_scene<3>(*shape, settings);
  const Truth truth = truth_at_surfels<3>(*shape, settings, scene.surfels, {"mean"});
  const auto made = find_estimator(estimator).variant<3>().make(scene.set, {});
  made->init({h}, RadiusRule{3, 0.33}.at({h}));
  const Estimates estimates = made->eval(scene.surfels);
  Errors errors;
  for (std::size_t i = 0; i < scene.surfels.size(); ++i) {
    const double error = std::abs(estimates["mean"][i] - truth.columns[0][i]);
    errors.sup = std::max(errors.sup, error);
    errors.rms += error * error / double(scene.surfels.size());
  }
  errors.rms = std::sqrt(errors.rms);
  return errors;
}

using std::numbers::pi;

/// The measures of the whole surface of a set, or in the ball of some radius, in cells, around one of its faces.
template <class Current>
CurvatureMeasures measures_in_ball(const QuadSurface& surface, const Current& current, std::uint32_t face,
                                   double radius) {
  CurvatureMeasures sum;
  BallWalk walk(surface);
  const LatticePoint<3> centre = surface.faces()[face].cell().coordinates;
  walk(face, 2 * radius, [&](std::uint32_t other) { sum += current.in_ball(other, centre, 2 * radius); });
  return sum;
}

QuadSurface whole_surface(const DigitalSet<3>& set) {
  return {set, boundary(set), {1}};
}

template <class Normal>
std::vector<Eigen::Vector3d> normals_of(const QuadSurface& surface, Normal normal) {
  std::vector<Eigen::Vector3d> normals;
  for (const Surfel<3>& surfel : surface.faces()) normals.push_back(normal(surfel));
  return normals;
}

TEST(ConstantCorrectedCurrent, OfABoxWithItsOwnNormalsHasItsEdgesAndVertices) {
  const QuadSurface surface = whole_surface(
      set_where<3>({{-2, 0, 1}, {4, 3, 5}}, [](const LatticePoint<3>&) { return true; }));  // 7 x 4 x 5
  const ConstantCurrent current(surface, normals_of(surface, [](const auto& s) { return s.normal(); }));
  const CurvatureMeasures sum = measures_in_ball(surface, current, 0, 100);
  EXPECT_NEAR(sum.mu0, 2 * (7 * 4 + 4 * 5 + 5 * 7), 1e-11);
  EXPECT_NEAR(sum.mu1(), 4 * (7 + 4 + 5) * pi / 2, 1e-11);
  EXPECT_NEAR(sum.mu2, 4 * pi, 1e-11);
}

/// With the exact normals of a ball and of a cylinder along z, both currents have their curvatures in every ball, up
/// to the distance, below a cell, between the digital surface and the smooth one.
template <class Current>
void expect_exact_curvature() {
  const double R = 20, within = 2 / (R * R);
  const QuadSurface ball = whole_surface(ball_set<3>(R));
  const Current of_ball(ball, normals_of(ball, [](const auto& s) { return centre(s, 1).normalized(); }));
  const QuadSurface tube = whole_surface(set_where<3>(
      {{-21, -21, -12}, {21, 21, 12}}, [&](const auto& z) { return z[0] * z[0] + z[1] * z[1] <= R * R; }));
  const auto radial = [](const Surfel<3>& s) {
    const RealPoint<3> p = centre(s, 1);
    return RealPoint<3>(p[0], p[1], 0).normalized();
  };
  const Current of_tube(tube, normals_of(tube, radial));
  for (std::uint32_t f = 0; f < ball.faces().size(); f += 7) {
    const auto [mean, gaussian, principal] =
        curvature_of(measures_in_ball(ball, of_ball, f, 5), of_ball.normal(f));
    EXPECT_NEAR(mean, 1 / R, within);
    EXPECT_NEAR(gaussian, 1 / (R * R), 2 * within / R);
    EXPECT_NEAR(principal.k1, 1 / R, within);
    EXPECT_NEAR(principal.k2, 1 / R, within);
  }
  for (std::uint32_t f = 0; f < tube.faces().size(); f += 7) {
    if (std::abs(centre(tube.faces()[f], 1)[2]) > 5) continue;  // away from its ends
    const auto [mean, gaussian, principal] =
        curvature_of(measures_in_ball(tube, of_tube, f, 5), of_tube.normal(f));
    EXPECT_NEAR(mean, 0.5 / R, within / 2);
    EXPECT_NEAR(gaussian, 0, 1e-14);
    EXPECT_NEAR(principal.k1, 1 / R, within);
    EXPECT_NEAR(principal.k2, 0, within);
    EXPECT_NEAR(std::abs(principal.dir2[2]), 1, 0.01);
  }
}

TEST(InterpolatedCorrectedCurrent, HasTheCurvatureOfItsNormals) {
  expect_exact_curvature<InterpolatedCurrent>();
}
TEST(ConstantCorrectedCurrent, HasTheCurvatureOfItsNormals) {
  expect_exact_curvature<ConstantCurrent>();
}

/// What the authors' comparison of integral invariants and corrected currents prints (DGtal,
/// curvature-comparator-ii-cnc-3d: normals with R = 3 h^0.33, balls of radius h^1/2), within 1 %: their normals at
/// the closest points are found along the gradient, their squares halved to triangles.
TEST(InterpolatedCorrectedCurrent, HasThePublishedErrorsOnGoursatsSurface) {
  const Errors coarse = errors_on_goursat("icnc", 0.5), fine = errors_on_goursat("icnc", 0.125);
  EXPECT_NEAR(coarse.sup, 0.0641, 0.01 * 0.0641);
  EXPECT_NEAR(coarse.rms, 0.0199, 0.01 * 0.0199);
  EXPECT_NEAR(fine.sup, 0.02954, 0.01 * 0.02954);
  EXPECT_NEAR(fine.rms, 0.00730, 0.01 * 0.00730);
}

TEST(ConstantCorrectedCurrent, IsAsGoodAsTheInterpolatedOneOnGoursatsSurface) {
  const Errors constant = errors_on_goursat("ccnc", 0.5), interpolated = errors_on_goursat("icnc", 0.5);
  EXPECT_NEAR(constant.rms, interpolated.rms, 0.2 * interpolated.rms);
  EXPECT_NEAR(constant.sup, interpolated.sup, 0.2 * interpolated.sup);
}

}  // namespace
}  // namespace gridstep
