#include "estimators/integral_invariant/curvature.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "estimators/catalogue.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/scene.hpp"

namespace gridstep {
namespace {

using std::numbers::pi;

/// Area of the intersection of a disk of radius `rho` and one of radius R around a point of its circle.
double area_in_disk(double rho, double R) {
  const double beta =
      std::acos(R / (2 * rho));        // half the angle of the arc of the small disk inside the other
  const double gamma = pi - 2 * beta;  // the same of the large disk
  return R * R * (beta - std::sin(2 * beta) / 2) + rho * rho * (gamma - std::sin(2 * gamma) / 2);
}

/// Volume of the intersection of a ball of radius `rho` and one of radius R around a point of its sphere:
/// two caps at distance d = rho give pi R^3 (2/3 - R/(4 rho)).
double volume_in_ball(double rho, double R) {
  return pi * R * R * R * (2.0 / 3 - R / (4 * rho));
}

TEST(CurvatureFromArea, VanishesOnAHalfPlane) {
  for (const double R : {0.01, 1.0, 30.0})
    EXPECT_NEAR(curvature_from_area(pi * R * R / 2, {R}), 0, 1e-13 / R);
}

TEST(CurvatureFromArea, TendsToThatOfADiskQuadratically) {
  for (const double rho : {0.5, 3.0, 20.0}) {
    double previous = 0;
    for (const double q : {0.4, 0.2, 0.1, 0.05}) {
      const double R = q * rho;
      const double error = curvature_from_area(area_in_disk(rho, R), {R}) * rho - 1;
      EXPECT_LT(std::abs(error), 0.1 * q * q);
      if (previous != 0) {
        EXPECT_NEAR(previous / error, 4, 0.15);
      }
      previous = error;
      // Of the part outside the disk it is the opposite.
      EXPECT_NEAR(curvature_from_area(pi * R * R - area_in_disk(rho, R), {R}),
                  -curvature_from_area(area_in_disk(rho, R), {R}), 1e-11 / R);
    }
  }
}

TEST(MeanCurvatureFromVolume, VanishesOnAHalfSpace) {
  for (const double R : {0.01, 1.0, 30.0})
    EXPECT_NEAR(mean_curvature_from_volume(2 * pi * R * R * R / 3, {R}), 0, 1e-13 / R);
}

TEST(MeanCurvatureFromVolume, IsExactOnBalls) {
  for (const double rho : {0.5, 3.0, 20.0})
    for (const double q : {1.5, 0.4, 0.01}) {
      const double R = q * rho;
      EXPECT_NEAR(mean_curvature_from_volume(volume_in_ball(rho, R), {R}), 1 / rho, 1e-12 / R);
      EXPECT_NEAR(mean_curvature_from_volume(4 * pi * R * R * R / 3 - volume_in_ball(rho, R), {R}), -1 / rho,
                  1e-12 / R);
    }
}

/// J of the part of a ball below z = -(a x^2 + b y^2)/2, to first order in a and b. Its moments in
/// cylindrical coordinates, with r <= R and w = sqrt(R^2 - r^2):
///   int z = -pi R^4/4,  int z^2 = 2 pi R^5/15,  int x^2 = int_half-ball - (3a + b) pi R^6/48 (y^2: a + 3b).
/// The term in z^2 has no first-order change but through the centroid.
Eigen::Matrix3d covariance_below_paraboloid(double a, double b, double R) {
  const double R5 = std::pow(R, 5), R6 = std::pow(R, 6);
  const double volume = 2 * pi * R * R * R / 3 - (a + b) * pi * std::pow(R, 4) / 8;
  const double z = -pi * std::pow(R, 4) / 4;
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  J(0, 0) = 2 * pi * R5 / 15 - (3 * a + b) * pi * R6 / 48;
  J(1, 1) = 2 * pi * R5 / 15 - (a + 3 * b) * pi * R6 / 48;
  J(2, 2) = 2 * pi * R5 / 15 - z * z / volume;
  return J;
}

TEST(PrincipalCurvatures, VanishOnAHalfSpace) {
  const double R = 2.5;
  const auto result = principal_curvatures(covariance_below_paraboloid(0, 0, R), {0, 0, -1}, {R});
  EXPECT_NEAR(result.k1, 0, 1e-12);
  EXPECT_NEAR(result.k2, 0, 1e-12);
  EXPECT_NEAR(result.normal[2], 1, 1e-12);
}

TEST(PrincipalCurvatures, OfAParaboloidBelongToTheirDirections) {
  const double R = 0.7;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  for (const auto& [a, b] :
       {std::pair{0.02, 0.005}, {0.005, 0.02}, {0.02, -0.01}, {-0.03, -0.01}, {0.01, 0.0}}) {
    const Eigen::Matrix3d J = turn * covariance_below_paraboloid(a, b, R) * turn.transpose();
    for (const double outward : {1.0, -1.0}) {
      const auto result = principal_curvatures(J, -outward * turn.col(2), {R});
      EXPECT_NEAR(result.k1, std::max(a, b), 1e-10);
      EXPECT_NEAR(result.k2, std::min(a, b), 1e-10);
      EXPECT_NEAR(std::abs(result.dir1.dot(turn.col(a > b ? 0 : 1))), 1, 1e-9);
      EXPECT_NEAR(std::abs(result.dir2.dot(turn.col(a > b ? 1 : 0))), 1, 1e-9);
      EXPECT_NEAR(result.normal.dot(turn.col(2)), outward, 1e-9);
    }
  }
}

/// Mean over surfels of |cos| of the angle between the estimated and the true first direction, where the
/// truth is known and `counts` says so.
template <class Counts>
double alignment_of_dir1(const std::string& spec, double h, double R, Counts counts) {
  const auto shape = make_shape<3>(spec);
  SceneSettings<3> settings;
  settings.h = {h};
  settings.placement.shift = {0.13, -0.27, 0.4};
  const Scene<3> scene = make_scene<3>(*shape, settings);
  const Truth truth =
      truth_at_surfels<3>(*shape, scene.settings, scene.surfels, {"dir1_x", "dir1_y", "dir1_z"});
  const auto estimator = find_estimator("ii-covariance").variant<3>().make(scene.set, {});
  estimator->init({h}, {R});
  const Estimates estimates = estimator->eval(scene.surfels);
  double total = 0;
  int count = 0;
  for (std::size_t i = 0; i < scene.surfels.size(); ++i) {
    if (!truth.known[i] || !counts(centre(scene.surfels[i], h))) continue;
    double cosine = 0;
    for (std::size_t k = 0; k < 3; ++k)
      cosine += truth.columns[k][i] * estimates[std::string("dir1_") + "xyz"[k]][i];
    total += std::abs(cosine);
    ++count;
  }
  EXPECT_GT(count, 500);
  return total / count;
}

TEST(PrincipalDirections, TheFirstRunsAlongTheCircleOfACylinder) {
  const auto far_from_caps = [](const RealPoint<3>& p) { return std::abs(p[2]) < 3; };
  EXPECT_GT(alignment_of_dir1("cylinder:radius=3,height=10", 0.2, 1.6, far_from_caps), 0.99);
}

TEST(PrincipalDirections, TheFirstRunsAroundTheTubeOfATorus) {
  const auto everywhere = [](const RealPoint<3>&) { return true; };
  EXPECT_GT(alignment_of_dir1("torus:major=6,minor=2", 0.25, 1.3, everywhere), 0.97);
}

}  // namespace
}  // namespace gridstep
