#include "estimators/surface/curvature_measures.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

Vector3d random_vector(RandomStream& random) {
  return {2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1};
}

/// The integral of f over [0, 1].
template <class Function>
auto integral(Function f) {
  decltype(f(0.5)) sum = 0 * f(0.5);
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
    for (const double sign : {-1.0, 1.0})
      sum += Gauss::weights()[i] / 2 * f((1 + sign * Gauss::abscissa()[i]) / 2);
  return sum;
}

struct Forms {
  double mu0, mu1, mu2;
  Matrix3d M;
};

/// The invariant forms at a point, each written from its definition.
Forms forms(const Vector3d& u, const Vector3d& xs, const Vector3d& xt, const Vector3d& us,
            const Vector3d& ut) {
  const auto det = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return (Matrix3d() << a, b, c).finished().determinant();
  };
  return {det(u, xs, xt), det(u, us, xt) + det(u, xs, ut), det(u, us, ut),
          us * xt.cross(u).transpose() + ut * u.cross(xs).transpose()};
}

TEST(CurvatureMeasures, OfABilinearFieldAreTheIntegralsOfTheForms) {
  RandomStream random({31});
  for (int repeated = 0; repeated < 20; ++repeated) {
    std::array<Vector3d, 4> u;
    for (Vector3d& corner : u) corner = random_vector(random);
    const Vector3d a = random_vector(random), b = random_vector(random);
    const auto at = [&](double s, double t) {
      return forms((1 - s) * (1 - t) * u[0] + s * (1 - t) * u[1] + s * t * u[2] + (1 - s) * t * u[3], a, b,
                   (1 - t) * (u[1] - u[0]) + t * (u[2] - u[3]), (1 - s) * (u[3] - u[0]) + s * (u[2] - u[1]));
    };
    const auto over_square = [&](auto member) {
      return integral(
          [&](double t) { return integral([&](double s) { return std::invoke(member, at(s, t)); }); });
    };
    const CurvatureMeasures measures = measures_of_bilinear(u, a, b);
    EXPECT_NEAR(measures.mu0, over_square(&Forms::mu0), 1e-13);
    EXPECT_NEAR(measures.mu1(), over_square(&Forms::mu1), 1e-13);
    EXPECT_NEAR(measures.mu2, over_square(&Forms::mu2), 1e-13);
    Matrix3d M = Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) M(i, j) = over_square([i, j](const Forms& f) { return double(f.M(i, j)); });
    EXPECT_NEAR((measures.M - M).norm(), 0, 1e-13);
  }
}

TEST(CurvatureMeasures, OfAnEdgeAreTheIntegralsOverTheArcOfNormals) {
  RandomStream random({32});
  for (int repeated = 0; repeated < 20; ++repeated) {
    const Vector3d right = random_vector(random).normalized(), left = random_vector(random).normalized(),
                   edge = random_vector(random);
    const double angle = std::acos(right.dot(left));
    const auto at = [&](double t) -> Vector3d {  // on the great circle, by its well-known formula
      return (std::sin((1 - t) * angle) * right + std::sin(t * angle) * left) / std::sin(angle);
    };
    const auto along = [&](double t) -> Vector3d {
      return angle * (-std::cos((1 - t) * angle) * right + std::cos(t * angle) * left) / std::sin(angle);
    };
    Matrix3d M = Matrix3d::Zero();
    double mu1 = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        M(i, j) = integral([&](double t) {
          return forms(at(t), edge, Vector3d::Zero(), Vector3d::Zero(), along(t)).M(i, j);
        });
    mu1 = integral(
        [&](double t) { return forms(at(t), edge, Vector3d::Zero(), Vector3d::Zero(), along(t)).mu1; });
    const Matrix3d measured = second_measure_of_edge(right, left, edge);
    EXPECT_NEAR((measured - M).norm(), 0, 1e-11);
    EXPECT_NEAR(measured.trace(), mu1, 1e-11);
  }
}

TEST(CurvatureMeasures, OfTheEdgeOfACubeIsARightAngle) {
  const Vector3d right = Vector3d::UnitX(), left = Vector3d::UnitZ(), edge = 3 * Vector3d::UnitY();
  EXPECT_NEAR(second_measure_of_edge(right, left, edge).trace(), 3 * pi / 2, 1e-14);
  EXPECT_NEAR(second_measure_of_edge(left, right, edge).trace(), -3 * pi / 2, 1e-14) << "concave";
  EXPECT_EQ(second_measure_of_edge(right, right, edge), Matrix3d::Zero());
  EXPECT_EQ(second_measure_of_edge(right, -right, edge), Matrix3d::Zero());
}

TEST(CurvatureMeasures, OfAVertexAreAreasOnTheSphere) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  EXPECT_NEAR(area_on_sphere(std::vector{x, y, z}), pi / 2, 1e-14);
  EXPECT_NEAR(area_on_sphere(std::vector{z, y, x}), -pi / 2, 1e-14);
  EXPECT_NEAR(area_on_sphere(std::vector{x, y, x, y}), 0, 1e-14);
  // A small polygon around z: its area in the plane.
  std::vector<Vector3d> small;
  for (int i = 0; i < 6; ++i)
    small.push_back(Vector3d(1e-3 * std::cos(pi * i / 3), 1e-3 * std::sin(pi * i / 3), 1).normalized());
  EXPECT_NEAR(area_on_sphere(small) / (1.5e-6 * std::sqrt(3.0)), 1, 1e-5);
}

TEST(CurvatureMeasures, GiveTheCurvaturesOfACylinder) {
  // A strip along y of the cylinder of radius 2 around the y axis, by its exact normals.
  const double R = 2, width = 0.1;
  const Vector3d n0(std::sin(-width / 2), 0, std::cos(width / 2)),
      n1(std::sin(width / 2), 0, std::cos(width / 2));
  const CurvatureMeasures strip = measures_of_bilinear({n0, n1, n1, n0}, R * (n1 - n0), Vector3d(0, 0.7, 0));
  const MeasuredCurvature curvature = curvature_of(strip, Vector3d::UnitZ());
  EXPECT_NEAR(curvature.mean, 0.25, 1e-14);
  EXPECT_NEAR(curvature.gaussian, 0, 1e-14);
  EXPECT_NEAR(curvature.principal.k1, 0.5, 1e-14);
  EXPECT_NEAR(curvature.principal.k2, 0, 1e-14);
  EXPECT_NEAR(std::abs(curvature.principal.dir1[0]), 1, 1e-14);
  EXPECT_NEAR(std::abs(curvature.principal.dir2[1]), 1, 1e-14);
  EXPECT_EQ(curvature.principal.normal, Vector3d::UnitZ());
}

TEST(CurvatureMeasures, WithoutAreaGiveNoCurvature) {
  const MeasuredCurvature curvature = curvature_of({}, Vector3d::UnitX());
  EXPECT_EQ(curvature.mean, 0);
  EXPECT_EQ(curvature.gaussian, 0);
  EXPECT_EQ(curvature.principal.k1, 0);
  EXPECT_NEAR(curvature.principal.dir1.norm(), 1, 1e-15);
}

}  // namespace
}  // namespace gridstep
