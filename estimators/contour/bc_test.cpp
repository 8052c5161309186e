#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "estimators/catalogue.hpp"
#include "estimators/contour/digital_contour.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

Estimates estimate(const std::vector<Surfel<2>>& linels, double h) {
  const DigitalSet<2> unused({LatticePoint<2>{0, 0}, LatticePoint<2>{0, 0}});
  const auto estimator = find_estimator("bc").variant<2>().make(unused, {});
  estimator->init({h}, {1.0});
  return estimator->eval(linels);
}

/// A lopsided set with convex and concave parts, and a hole.
DigitalSet<2> bean() {
  return set_where<2>({LatticePoint<2>{-40, -40}, LatticePoint<2>{40, 40}}, [](const LatticePoint<2>& z) {
    const int x = z[0], y = z[1];
    return x * x + 3 * y * y < 1000 && x * x + (y + 12) * (y + 12) > 80 && (x - 18) * (x - 18) + y * y > 25;
  });
}

// Rows of a dump of DGtal 2.1.1 (commit 1574af90c): Khalimsky coordinates of the linel, estimate.
TEST(BinomialCurvature, AgreesWithDGtal) {
  const auto shape = make_shape<2>("flower:radius=20,amplitude=10,petals=6,phase=3");
  const auto linels = connected_boundary(gauss_digitize<2>(*shape, {0.1})).surfels;
  const Estimates estimates = estimate(linels, 0.1);
  ASSERT_EQ(linels.size(), 3572u);
  const auto expect = [&](int kx, int ky, double kappa) {
    const auto found = std::find_if(linels.begin(), linels.end(), [&](const Surfel<2>& linel) {
      return linel.cell().coordinates == LatticePoint<2>(kx, ky);
    });
    ASSERT_NE(found, linels.end());
    EXPECT_NEAR(estimates["kappa"][std::size_t(found - linels.begin())], kappa, 1e-9);
  };
  expect(257, -258, 0.0264312911548);
  expect(329, -60, 0.0211868833405);
  expect(520, 295, 0.328505401726);
  expect(-526, 235, 0.227234246535);
  expect(-108, 285, 0.00834579073906);
  expect(-108, 171, -1.28909201379);
  expect(-131, 182, -0.520048053179);
  expect(-523, 292, 0.403279330011);
}

// The midpoints of a square's sides are a sampled circle, which the mask scales by cos^2n(pi/4) = 2^-n.
TEST(BinomialCurvature, OfOneCellHasAClosedForm) {
  DigitalSet<2> set({LatticePoint<2>{0, 0}, LatticePoint<2>{9, 9}});
  set.set({5, 7}, true);
  const auto linels = connected_boundary(set).surfels;
  for (const auto& [h, n] : {std::pair{1.0, 1}, {0.125, 2}, {1e-4, 22}}) {
    const double kappa = std::sqrt(2.0) * std::pow(2.0, n) / h;
    const Estimates estimates = estimate(linels, h);
    for (const double value : estimates["kappa"]) EXPECT_NEAR(value, kappa, 1e-10 * kappa);
  }
}

TEST(BinomialCurvature, IsFiniteWhereTheMaskSwallowsTheContour) {
  DigitalSet<2> set({LatticePoint<2>{0, 0}, LatticePoint<2>{9, 9}});
  set.set({5, 7}, true);
  const auto linels = connected_boundary(set).surfels;
  for (const double h : {1e-8, 1e-9, 1e-10, 1e-30}) {
    const Estimates estimates = estimate(linels, h);
    for (std::size_t i = 0; i < linels.size(); ++i) {
      EXPECT_TRUE(std::isfinite(estimates["kappa"][i]));
      EXPECT_NEAR(std::hypot(estimates["tangent_x"][i], estimates["tangent_y"][i]), 1, 1e-12);
    }
  }
  const Estimates swallowed = estimate(linels, 1e-10);
  for (std::size_t i = 0; i < linels.size(); ++i) {
    const LatticePoint<2> step = end_pointel(linels[i]) - start_pointel(linels[i]);
    EXPECT_EQ(swallowed["kappa"][i], 0);
    EXPECT_EQ(swallowed["tangent_x"][i], step[0]);
    EXPECT_EQ(swallowed["tangent_y"][i], step[1]);
  }
}

TEST(BinomialCurvature, OfACircleIsNearTheInverseOfItsRadius) {
  for (const double h : {1.0, 0.1, 0.02}) {
    const double r = 20.3;
    const auto linels = connected_boundary(ball_set<2>(r / h)).surfels;
    const Estimates estimates = estimate(linels, h);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < linels.size(); ++i) {
      const double error = estimates["kappa"][i] * r - 1;
      sum += error;
      squares += error * error;
      const RealPoint<2> x = centre(linels[i], h).normalized();
      EXPECT_GT(x[0] * estimates["tangent_y"][i] - x[1] * estimates["tangent_x"][i], 0.99);
    }
    EXPECT_LT(std::abs(sum) / double(linels.size()), 0.02 * std::cbrt(h));
    EXPECT_LT(std::sqrt(squares / double(linels.size())), 0.1 * std::cbrt(h));
  }
}

TEST(BinomialCurvature, TangentsWalkOnceAroundWithTheSetOnTheLeft) {
  const DigitalSurface<2> surface = connected_boundary(bean());
  ASSERT_EQ(surface.components(), 2u);
  const Estimates estimates = estimate(surface.surfels, 0.5);
  const auto tangent = [&](std::size_t i) {
    return std::complex<double>(estimates["tangent_x"][i], estimates["tangent_y"][i]);
  };
  for (std::size_t c = 0; c < 2; ++c) {
    const std::size_t begin = surface.component_begin[c], end = surface.component_begin[c + 1];
    double turning = 0;
    for (std::size_t i = begin; i < end; ++i) {
      EXPECT_NEAR(std::abs(tangent(i)), 1, 1e-12);
      turning += std::arg(tangent(i + 1 < end ? i + 1 : begin) / tangent(i));
    }
    EXPECT_NEAR(turning, (c == 0 ? 2 : -2) * std::numbers::pi, 1e-9);
  }
}

TEST(BinomialCurvature, IsNegativeAroundAHole) {
  const auto ring = set_where<2>({LatticePoint<2>{-30, -30}, LatticePoint<2>{30, 30}}, [](const auto& z) {
    return z.squaredNorm() < 25 * 25 && z.squaredNorm() > 10 * 10;
  });
  const DigitalSurface<2> surface = connected_boundary(ring);
  ASSERT_EQ(surface.components(), 2u);
  const auto kappa = estimate(surface.surfels, 1.0)["kappa"];
  for (std::size_t i = 0; i < kappa.size(); ++i) EXPECT_EQ(kappa[i] > 0, i < surface.component_begin[1]);
}

TEST(BinomialCurvature, TurnsWithTheSet) {
  const DigitalSet<2> set = bean();
  DigitalSet<2> turned({LatticePoint<2>{-41, -41}, LatticePoint<2>{41, 41}});
  for_each_point_of(set, [&](const LatticePoint<2>& z) { turned.set({-z[1], z[0]}, true); });
  const auto linels = connected_boundary(set).surfels, turned_linels = connected_boundary(turned).surfels;
  const Estimates estimates = estimate(linels, 0.5), turned_estimates = estimate(turned_linels, 0.5);
  ASSERT_EQ(linels.size(), turned_linels.size());
  for (std::size_t i = 0; i < linels.size(); ++i) {
    const auto k = linels[i].cell().coordinates;
    const auto found = std::find_if(turned_linels.begin(), turned_linels.end(), [&](const Surfel<2>& linel) {
      return linel.cell().coordinates == LatticePoint<2>(2 - k[1], k[0]);
    });
    ASSERT_NE(found, turned_linels.end());
    const auto j = std::size_t(found - turned_linels.begin());
    EXPECT_NEAR(turned_estimates["kappa"][j], estimates["kappa"][i], 1e-12);
    EXPECT_NEAR(turned_estimates["tangent_x"][j], -estimates["tangent_y"][i], 1e-12);
    EXPECT_NEAR(turned_estimates["tangent_y"][j], estimates["tangent_x"][i], 1e-12);
  }
}

TEST(BinomialCurvature, DoesNotDependOnWhereTheContourStarts) {
  const DigitalSurface<2> surface = connected_boundary(bean());
  const std::vector<Surfel<2>> linels(surface.surfels.begin(),
                                      surface.surfels.begin() + std::ptrdiff_t(surface.component_begin[1]));
  const Estimates estimates = estimate(linels, 0.5);
  for (const std::size_t start : {1u, 17u, 50u}) {
    auto shifted = linels;
    std::rotate(shifted.begin(), shifted.begin() + std::ptrdiff_t(start), shifted.end());
    const Estimates from_start = estimate(shifted, 0.5);
    for (std::size_t i = 0; i < linels.size(); ++i)
      for (std::size_t q = 0; q < estimates.columns.size(); ++q)
        EXPECT_NEAR(from_start.columns[q][i], estimates.columns[q][(i + start) % linels.size()], 1e-12);
  }
}

TEST(BinomialCurvature, DoesNotDependOnWhereTheSetIs) {
  const auto linels = connected_boundary(bean()).surfels;
  auto moved = linels;
  for (Surfel<2>& linel : moved) linel.inner += LatticePoint<2>(1 << 28, -(1 << 28) + 5);
  EXPECT_EQ(estimate(moved, 0.5).columns, estimate(linels, 0.5).columns);
}

}  // namespace
}  // namespace gridstep
