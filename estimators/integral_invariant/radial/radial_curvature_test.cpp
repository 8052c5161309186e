#include "estimators/integral_invariant/radial/radial_curvature.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>

namespace gridstep {
namespace {

using std::numbers::pi;

/// PF, HO1 and HO2: one, two and three vanishing moments.
RadialKernels kernels(int d, int vanishing) {
  if (vanishing == 1)
    return {vanishing_kernel(d, 1, std::array{0}), vanishing_kernel(d, 1, {}), vanishing_kernel(3, 1, {})};
  if (vanishing == 2)
    return {vanishing_kernel(d, 1, std::array{0, 4}), vanishing_kernel(d, 1, std::array{4}),
            vanishing_kernel(3, 1, std::array{6})};
  return {vanishing_kernel(d, 1, std::array{0, 4, 6}), vanishing_kernel(d, 1, std::array{4, 6}),
          vanishing_kernel(3, 1, std::array{6, 8})};
}

template <class Function>
double integral(Function f, double a, double b) {
  boost::math::quadrature::tanh_sinh<double> integrator(12);
  return a < b ? integrator.integrate(f, a, b, 1e-13) : 0;
}

/// The ball, or disk, of curvature kappa whose boundary passes at height delta over the origin: of the sphere of radius r
/// around the origin it holds the part below height(r), between -r and r.
struct OffCentre {
  double rise, bend;

  OffCentre(double kappa, double delta)
      : rise(delta * (2 - kappa * delta) / (2 * (1 - kappa * delta))),
        bend(kappa / (1 - kappa * delta) / 2) {}
  double height(double r) const { return std::clamp(rise - bend * r * r, -r, r); }

  /// Integral over the unit ball of g, on each sphere times share(r); in two parts, as spheres near the centre lie all
  /// inside, or all outside.
  template <class Share>
  double integral_of(const RadialKernel& g, Share share) const {
    const double whole =
        bend == 0 ? std::abs(rise) : std::abs((std::sqrt(1 + 4 * bend * rise) - 1) / (2 * bend));
    const auto f = [&](double r) { return r == 0 ? 0 : g(r * r) * share(r); };
    return integral(f, 0, whole) + integral(f, whole, 1);
  }
};

/// Less what a half-space has.
double in_ball(const RadialKernel& g, double kappa, double delta) {
  const OffCentre ball(kappa, delta);
  return ball.integral_of(g, [&](double r) { return 2 * pi * r * ball.height(r); });
}
double in_disk(const RadialKernel& g, double kappa, double delta) {
  const OffCentre disk(kappa, delta);
  return disk.integral_of(g, [&](double r) { return 2 * r * std::asin(disk.height(r) / r); });
}

TEST(RadialCurvature3D, HasTheConstantsOfTheClosedForms) {
  // H = 24 C / (pi R) for (1 - t)(1 - 3 t), 120 C / (pi R) for (1 - t)(1 - 7 t + 8 t^2).
  for (const auto& [vanishing, factor] : {std::pair{1, 24 / pi}, {2, 120 / pi}, {3, 360 / pi}}) {
    const RadialKernels k = kernels(3, vanishing);
    const double trace = 1e-4, t = 2 * factor * trace;
    // An edge integral that says delta = 0.
    const double edge = -t * k.edge.moment(2, 2) / 4;
    const auto c = RadialCurvature(k).in_3d(trace, edge, {0, 0, -1}, Eigen::Matrix3d::Zero(), {1, 0, 0});
    EXPECT_NEAR((c.k1 + c.k2) / 2, factor * trace, 1e-12);
  }
}

TEST(RadialCurvature2D, HasTheConstantsOfTheClosedForms) {
  // kappa = -525/16 C for (1 - t)(t - 1/5) = -(1 - t)(1 - 5 t) / 5, and 1575/64 C for the other.
  for (const auto& [vanishing, factor] :
       {std::pair{1, 525 / 16.0 / 5}, {2, 1575 / 64.0}, {3, 121275 / 2048.0}}) {
    const RadialKernels k = kernels(2, vanishing);
    const double trace = 1e-4, kappa = factor * trace;
    EXPECT_NEAR(RadialCurvature(k).in_2d(trace, -kappa * k.edge.moment(1, 2) / 2), kappa, 1e-12);
  }
}

TEST(RadialCurvature3D, IsExactOnBallsThroughTheCentre) {
  for (const int vanishing : {1, 2, 3})
    for (const double kappa : {-1.5, -0.3, 0.0, 0.2, 1.0}) {
      const RadialKernels k = kernels(3, vanishing);
      EXPECT_NEAR(-4 * in_ball(k.trace, kappa, 0) / k.trace.moment(2, 2) / 2, kappa, 1e-11);
    }
}

TEST(RadialCurvature3D, HasTheMeanAloneButForTheDifferenceOfTheCurvatures) {
  for (const int vanishing : {1, 2, 3})
    for (const double delta : {-0.04, 0.0, 0.04})
      for (const double s : {0.0, 0.2}) {
        const RadialKernels k = kernels(3, vanishing);
        const double trace = in_ball(k.trace, 0.2, delta), edge = in_ball(k.edge, 0.2, delta);
        // A tensor with no more than a deviator, that of principal curvatures 2 s apart.
        const double across = -s * k.tensor.moment(2, 4) / 8;
        const Eigen::Matrix3d tensor = Eigen::Vector3d(across, -across, 0).asDiagonal();
        const auto c = RadialCurvature(k).in_3d(trace, edge, {0, 0, -1}, tensor, {1, 0, 0});
        const double mean = RadialCurvature(k).mean_in_3d(trace, edge);
        EXPECT_NEAR(mean - (c.k1 + c.k2) / 2, delta * s * s / 2, 0.2 * std::abs(delta) * s * s / 2 + 1e-12);
      }
}

TEST(RadialCurvature3D, FollowsABallThatIsOffTheCentre) {
  // Without a correction, kappa gains kappa^2 delta, and delta^3 a constant of the kernel.
  for (const int vanishing : {1, 2, 3})
    for (const double kappa : {-0.2, 0.0, 0.1, 0.2})
      for (const double delta : {-0.04, 0.02, 0.04}) {
        // What is left of delta^5 grows with the number of moments.
        const double rest = vanishing < 3 ? 2e-5 : 5e-5;
        const RadialKernels k = kernels(3, vanishing);
        const auto c = RadialCurvature(k).in_3d(in_ball(k.trace, kappa, delta), in_ball(k.edge, kappa, delta),
                                                {0, 0, -1}, Eigen::Matrix3d::Zero(), {1, 0, 0});
        const double gain = kappa * kappa * std::abs(delta);
        EXPECT_NEAR((c.k1 + c.k2) / 2, kappa, 0.15 * gain + rest)
            << vanishing << " " << kappa << " " << delta;
      }
}

/// Integrals below z = delta - (k1 u^2 + k2 v^2) / 2, along z by Gauss's rule, over polar coordinates otherwise.
struct BelowParaboloid {
  double k1, k2, delta;

  template <class Integrand>
  double of(Integrand f) const {
    using Rule = boost::math::quadrature::gauss<double, 30>;
    return Rule::integrate(
        [&](double angle) {
          return Rule::integrate(
              [&](double r) {
                const double u = r * std::cos(angle), v = r * std::sin(angle), top = std::sqrt(1 - r * r);
                const double z = std::clamp(delta - (k1 * u * u + k2 * v * v) / 2, -top, top);
                return r * Rule::integrate([&](double s) { return f(u, v, s); }, 0.0, z);
              },
              0.0, 1.0);
        },
        0.0, 2 * pi);
  }
  double of(const RadialKernel& g) const {
    return of([&](double u, double v, double z) { return g(u * u + v * v + z * z); });
  }
  PrincipalCurvatures estimate(const RadialKernels& k, const Eigen::Matrix3d& turn) const {
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    tensor(0, 0) = of([&](double u, double v, double z) { return k.tensor(u * u + v * v + z * z) * u * u; });
    tensor(1, 1) = of([&](double u, double v, double z) { return k.tensor(u * u + v * v + z * z) * v * v; });
    return RadialCurvature(k).in_3d(of(k.trace), of(k.edge), -turn.col(2), turn * tensor * turn.transpose(),
                                    turn.col(0));
  }
};

TEST(RadialCurvature3D, FindsTheCurvaturesAndDirectionsOfParaboloids) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  for (const int vanishing : {1, 2, 3})
    for (const auto& [a, b] :
         {std::pair{0.05, 0.02}, {0.02, 0.05}, {0.04, -0.03}, {-0.02, -0.05}, {0.05, 0.0}}) {
      const auto c = BelowParaboloid{a, b, 0}.estimate(kernels(3, vanishing), turn);
      EXPECT_NEAR(c.k1, std::max(a, b), 2e-4);
      EXPECT_NEAR(c.k2, std::min(a, b), 2e-4);
      EXPECT_NEAR(std::abs(c.dir1.dot(turn.col(a > b ? 0 : 1))), 1, 1e-6);
      EXPECT_NEAR(std::abs(c.dir2.dot(turn.col(a > b ? 1 : 0))), 1, 1e-6);
      EXPECT_NEAR(c.normal.dot(turn.col(2)), 1, 1e-12);
    }
}

TEST(RadialCurvature3D, TakesOffWhatADistanceAdds) {
  // Between distances of the same size and opposite sign, all but a tenth of what a cylinder or a saddle would gain.
  for (const int vanishing : {1, 2, 3})
    for (const auto& [a, b] : {std::pair{0.3, 0.0}, {0.3, -0.2}, {0.3, 0.1}}) {
      const RadialKernels k = kernels(3, vanishing);
      const double delta = 0.02, t = a + b, s = (a - b) / 2;
      const auto up = BelowParaboloid{a, b, delta}.estimate(k, Eigen::Matrix3d::Identity());
      const auto down = BelowParaboloid{a, b, -delta}.estimate(k, Eigen::Matrix3d::Identity());
      const double gain_t = 2 * delta * (2 * (a * a + b * b) + t * t) / 4, gain_s = 2 * delta * 1.5 * t * s;
      EXPECT_LT(std::abs(up.k1 + up.k2 - down.k1 - down.k2), 0.1 * gain_t);
      EXPECT_LT(std::abs(up.k1 - up.k2 - down.k1 + down.k2) / 2, 0.1 * gain_s + 1e-6);
    }
}

TEST(RadialCurvature2D, FollowsADiskThatIsOffTheCentre) {
  const RadialKernels k = kernels(2, 2);
  for (const double kappa : {-0.3, 0.1, 0.3}) {
    EXPECT_NEAR(RadialCurvature(k).in_2d(in_disk(k.trace, kappa, 0), in_disk(k.edge, kappa, 0)), kappa,
                0.02 * std::abs(std::pow(kappa, 5)) + 1e-9);
    const double delta = 0.02;
    const auto at = [&](double distance) {
      return RadialCurvature(k).in_2d(in_disk(k.trace, kappa, distance), in_disk(k.edge, kappa, distance));
    };
    EXPECT_LT(std::abs(at(delta) - at(-delta)), 0.1 * 2 * 0.75 * delta * kappa * kappa + 2e-5);
  }
}

TEST(RadialCurvature3D, TakesTheNormalItIsGivenWhereThereIsNone) {
  const auto c =
      RadialCurvature(kernels(3, 1)).in_3d(0, 0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), {0, 1, 0});
  EXPECT_EQ(c.normal, Eigen::Vector3d(0, 1, 0));
}

}  // namespace
}  // namespace gridstep
