// The formulas of README.md beside this file, in fifty digits: against numerical integration, exact balls and half-spaces,
// and what the library computes.

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "estimators/integral_invariant/radial/radial_kernel.hpp"

namespace gridstep {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

const Real kPi = boost::math::constants::pi<Real>();
const Real kTiny = Real("1e-45");

Real ratio(int numerator, int denominator) {
  return Real(numerator) / denominator;
}

template <class Function>
Real integral(Function f, Real a, Real b) {
  return boost::math::quadrature::gauss<Real, 30>::integrate(f, a, b);
}

/// (1 - t)(1 + b t + c t^2 + e t^3).
struct Kernel {
  Real b = 0, c = 0, e = 0;

  Real operator()(const Real& t) const { return (1 - t) * (1 + t * (b + t * (c + t * e))); }
  Real slope(const Real& t) const { return b - 1 + t * (2 * (c - b) + t * (3 * (e - c) - 4 * t * e)); }

  /// Of f over the interval (dimension 1), disc (2) or ball (3), times |x|^order.
  template <class Function>
  static Real over(int dimension, int order, Function f) {
    const Real sphere = dimension == 1 ? Real(2) : dimension == 2 ? Real(2 * kPi) : Real(4 * kPi);
    return integral([&](const Real& r) { return Real(sphere * pow(r, order + dimension - 1) * f(r * r)); }, 0,
                    1);
  }
  Real moment(int dimension, int order) const { return over(dimension, order, *this); }
  Real slope_moment(int dimension, int order) const {
    return over(dimension, order, [this](const Real& t) { return slope(t); });
  }
};

/// A line of the tables of README.md.
struct Line {
  std::string name;
  Kernel kernel;
  std::vector<int> vanishing;  // orders
  std::vector<std::pair<int, Real>> moments;
  Real slope;  // S
};

std::vector<Line> lines(int d) {
  if (d == 3)
    return {{"pf1", {-3}, {0}, {{2, -kPi / 12}}, -kPi},
            {"ho1", {-7, 8}, {0, 4}, {{2, -kPi / 60}}, -kPi},
            {"edge pf1", {}, {}, {{0, kPi / 2}, {2, kPi / 6}}, -kPi},
            {"edge ho1", {-ratio(5, 3)}, {4}, {{0, 2 * kPi / 9}, {2, kPi / 36}}, -kPi},
            {"tensor pf1", {}, {}, {{4, kPi / 12}}, -kPi},
            {"tensor ho1", {-ratio(3, 2)}, {6}, {{4, kPi / 120}}, -kPi},
            {"ho2", {-ratio(37, 3), ratio(98, 3), -ratio(70, 3)}, {0, 4, 6}, {{2, -kPi / 180}}, -kPi},
            {"edge ho2", {-4, ratio(7, 2)}, {4, 6}, {{0, kPi / 8}, {2, kPi / 120}}, -kPi},
            {"tensor ho2", {-ratio(7, 2), ratio(14, 5)}, {6, 8}, {{4, kPi / 600}}, -kPi}};
  return {{"pf1", {-5}, {0}, {{2, -ratio(32, 105)}}, -ratio(16, 3)},
          {"ho1", {-ratio(58, 5), ratio(77, 5)}, {0, 4}, {{2, -ratio(128, 1575)}}, -ratio(192, 25)},
          {"edge pf1", {}, {}, {{0, ratio(4, 3)}, {2, ratio(4, 15)}}, -2},
          {"edge ho1", {-ratio(9, 5)}, {4}, {{0, ratio(64, 75)}, {2, ratio(32, 525)}}, -ratio(16, 5)},
          {"ho2",
           {-ratio(103, 5), ratio(2249, 35), -ratio(351, 7)},
           {0, 4, 6},
           {{2, -ratio(4096, 121275)}},
           -ratio(12288, 1225)},
          {"edge ho2",
           {-ratio(22, 5), ratio(143, 35)},
           {4, 6},
           {{0, ratio(768, 1225)}, {2, ratio(256, 11025)}},
           -ratio(768, 175)}};
}

void expect_near(const Real& value, const Real& expected, const Real& tolerance = kTiny) {
  EXPECT_LE(abs(value - expected), tolerance) << value << " is not " << expected;
}

TEST(ClosedForms, AreTheMomentsOverTheDisc) {
  for (const int d : {2, 3})
    for (const Line& line : lines(d)) {
      SCOPED_TRACE(line.name + (d == 2 ? " 2D" : " 3D"));
      for (const int order : line.vanishing) expect_near(line.kernel.moment(d - 1, order), 0);
      for (const auto& [order, moment] : line.moments) expect_near(line.kernel.moment(d - 1, order), moment);
      expect_near(line.kernel.slope_moment(d - 1, 0), line.slope);
    }
}

TEST(ClosedForms, AreThoseOfTheLibrary) {
  for (const int d : {2, 3})
    for (const Line& line : lines(d)) {
      SCOPED_TRACE(line.name + (d == 2 ? " 2D" : " 3D"));
      // The tensor's kernel is always one of three dimensions.
      const RadialKernel kernel = vanishing_kernel(d, 1, line.vanishing);
      for (const double t : {0.0, 0.1, 0.5, 0.9})
        EXPECT_NEAR(kernel(t), line.kernel(t).convert_to<double>(), 1e-12);
      for (const auto& [order, moment] : line.moments)
        EXPECT_NEAR(kernel.moment(d - 1, order), moment.convert_to<double>(), 1e-13);
      EXPECT_NEAR(kernel.slope_integral(d - 1), line.slope.convert_to<double>(), 1e-11);
    }
}

TEST(ClosedForms, FollowByPartialIntegration) {
  for (const Line& line : lines(3)) {
    expect_near(line.kernel.slope_moment(2, 2), -line.kernel.moment(2, 0));
    expect_near(line.kernel.slope_moment(2, 4), -2 * line.kernel.moment(2, 2));
    expect_near(line.kernel.slope_moment(2, 6), -3 * line.kernel.moment(2, 4));
  }
  for (const Line& line : lines(2)) {
    expect_near(line.kernel.slope_moment(1, 2), -line.kernel.moment(1, 0) / 2);
    expect_near(line.kernel.slope_moment(1, 4), -3 * line.kernel.moment(1, 2) / 2);
  }
}

/// C = integral of g over the ball around a boundary point of a ball of radius 1 / kappa, in the unit ball: on the sphere
/// of radius r around it, the part below height -kappa r^2 / 2, a zone, is inside.
Real in_ball(const Kernel& g, const Real& kappa) {
  return integral([&](const Real& r) { return Real(g(r * r) * 2 * kPi * r * (r - kappa * r * r / 2)); }, 0,
                  1);
}
/// The same for a disk: an arc.
Real in_disk(const Kernel& g, const Real& kappa) {
  return integral([&](const Real& r) { return Real(g(r * r) * r * (kPi - 2 * asin(kappa * r / 2))); }, 0, 1);
}

TEST(ClosedForms, AreExactOnBallsAndHalfSpaces) {
  const Real R = 3;  // C has no unit
  for (const Real& kappa : {Real(-1), Real(0), ratio(1, 10), ratio(3, 2)}) {
    const auto [pf1, ho1] = std::pair{lines(3)[0].kernel, lines(3)[1].kernel};
    expect_near(24 * in_ball(pf1, kappa) / (kPi * R) + 64 / (35 * R), kappa / R);
    expect_near(120 * in_ball(ho1, kappa) / (kPi * R) + 64 / (21 * R), kappa / R);
  }
}

TEST(ClosedForms, AreExactOnHalfPlanesAndToFifthOrderOnDisks) {
  const auto [pf1, ho1] = std::pair{lines(2)[0].kernel, lines(2)[1].kernel};
  const auto by_pf1 = [&, k = pf1](const Real& kappa) -> Real {
    return ratio(105, 16) * (in_disk(k, kappa) + kPi / 6);
  };
  const auto by_ho1 = [&, k = ho1](const Real& kappa) -> Real {
    return ratio(1575, 64) * (in_disk(k, kappa) + 3 * kPi / 40);
  };
  expect_near(by_pf1(0), 0);
  expect_near(by_ho1(0), 0);
  const Real kappa = Real("1e-6"), third = pf1.moment(1, 4) / (24 * pf1.moment(1, 2)),
             fifth = 3 * ho1.moment(1, 6) / (640 * ho1.moment(1, 2));
  expect_near((by_pf1(kappa) - kappa) / pow(kappa, 3), third, Real("1e-11"));
  expect_near((by_ho1(kappa) - kappa) / pow(kappa, 5), fifth, Real("1e-11"));
}

TEST(ClosedForms, HaveTheCubeOfADistance) {
  // A half-space at height delta: between 0 and delta lie intervals, or discs, of radius sqrt(1 - z^2).
  const Real delta = Real("1e-8");
  for (const int d : {2, 3})
    for (const Line& line : lines(d)) {
      const auto slice = [&](const Real& z) -> Real {
        const Real whole = sqrt(1 - z * z);
        return integral(
            [&](const Real& r) {
              return Real((d == 2 ? Real(2) : Real(2 * kPi * r)) * line.kernel(r * r + z * z));
            },
            0, whole);
      };
      const Real difference = integral(slice, 0, delta) - delta * line.kernel.moment(d - 1, 0);
      expect_near(difference / pow(delta, 3), line.slope / 3, Real("1e-14"));
    }
}

}  // namespace
}  // namespace gridstep
