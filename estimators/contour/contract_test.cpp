#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "estimators/catalogue.hpp"
#include "estimators/contour/digital_contour.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

// Contract tests of the estimators in the catalogue that take no radius: they look at whole contours.

namespace gridstep {
namespace {

using Contour = std::vector<Surfel<2>>;

class ContourContract : public testing::TestWithParam<std::string> {
 protected:
  const EstimatorEntry::Variant<2>& variant() const { return find_estimator(GetParam()).variant<2>(); }
  Estimates eval(const DigitalSet<2>& set, const Contour& linels, double h = 1) const {
    const auto estimator = variant().make(set, {});
    estimator->init({h}, {0});
    return estimator->eval(linels);
  }
  Estimates eval(const DigitalSet<2>& set, double h = 1) const {
    return eval(set, connected_boundary(set).surfels, h);
  }
};

bool is_tangent(const std::string& quantity) {
  return quantity.starts_with("tangent_");
}

/// A slanted egg without lattice symmetry, across zero and across bricks.
DigitalSet<2> egg(const LatticePoint<2>& shift = {0, 0}, double size = 30.3) {
  const int margin = int(2 * size);
  return set_where<2>({shift.array() - margin, shift.array() + margin}, [&](const LatticePoint<2>& z) {
    RealPoint<2> p = (z - shift).cast<double>();
    p[0] -= 0.3 * p[1] - 0.21;
    p[1] *= 1.6 + 0.004 * p[0];
    return p.squaredNorm() <= size * size;
  });
}

TEST_P(ContourContract, GivesAFiniteValueForEveryLinelAndQuantity) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto set =
        random_set<2>({LatticePoint<2>{-9, -8}, LatticePoint<2>{7, 9}}, 0.1 + 0.08 * double(seed), seed);
    const Contour linels = connected_boundary(set).surfels;
    const Estimates estimates = eval(set, linels);
    ASSERT_EQ(estimates.quantities.size(), variant().quantities.size());
    for (std::size_t c = 0; c < estimates.columns.size(); ++c) {
      EXPECT_EQ(estimates.quantities[c], variant().quantities[c].name);
      ASSERT_EQ(estimates.columns[c].size(), linels.size());
      for (const double value : estimates.columns[c]) ASSERT_TRUE(std::isfinite(value));
    }
  }
  EXPECT_TRUE(eval(egg(), Contour{}).columns.front().empty());
}

TEST_P(ContourContract, TakesTheSmallestContours) {
  // One cell, two cells, and a ring whose hole is one cell.
  for (const int cells : {1, 2, 3}) {
    DigitalSet<2> set({LatticePoint<2>{-3, -3}, LatticePoint<2>{4, 4}});
    if (cells == 3) for_each_point<2>({{-1, -1}, {1, 1}}, [&](const auto& z) { set.set(z, true); });
    set.set({0, 0}, cells < 3);
    if (cells == 2) set.set({1, 0}, true);
    for (const auto& column : eval(set).columns)
      for (const double value : column) EXPECT_TRUE(std::isfinite(value));
  }
}

TEST_P(ContourContract, DoesNotDependOnWhereTheContourStarts) {
  const auto set = egg();
  Contour linels = connected_boundary(set).surfels;
  const Estimates straight = eval(set, linels);
  for (const std::ptrdiff_t turn : {1, 37, 120}) {
    Contour turned = linels;
    std::rotate(turned.begin(), turned.begin() + turn, turned.end());
    const Estimates result = eval(set, turned);
    for (std::size_t c = 0; c < straight.columns.size(); ++c)
      for (std::size_t i = 0; i < linels.size(); ++i)
        ASSERT_NEAR(result.columns[c][i], straight.columns[c][(i + std::size_t(turn)) % linels.size()], 1e-9)
            << straight.quantities[c] << " of linel " << i;
  }
}

TEST_P(ContourContract, ContoursDoNotMix) {
  // Two sets far apart give what each of them gives alone.
  const auto a = egg(), b = egg({200, -40}, 17.4);
  DigitalSet<2> all({a.domain().lo.cwiseMin(b.domain().lo), a.domain().hi.cwiseMax(b.domain().hi)});
  for (const auto* set : {&a, &b})
    for_each_point_of(*set, [&](const LatticePoint<2>& z) { all.set(z, true); });
  Contour both = connected_boundary(a).surfels;
  const std::size_t n = both.size();
  for (const Surfel<2>& linel : connected_boundary(b).surfels) both.push_back(linel);
  const Estimates together = eval(all, both), first = eval(a), second = eval(b);
  for (std::size_t c = 0; c < first.columns.size(); ++c) {
    EXPECT_TRUE(std::equal(first.columns[c].begin(), first.columns[c].end(), together.columns[c].begin()));
    EXPECT_TRUE(std::equal(second.columns[c].begin(), second.columns[c].end(),
                           together.columns[c].begin() + std::ptrdiff_t(n)));
  }
}

/// Values on a set that a lattice isometry without reflection has moved, by linel of the set before.
TEST_P(ContourContract, CommutesWithTranslationsAndQuarterTurns) {
  const auto set = egg();
  const Contour linels = connected_boundary(set).surfels;
  const Estimates here = eval(set, linels);
  Eigen::Matrix2i quarter;
  quarter << 0, -1, 1, 0;
  Eigen::Matrix2i M = Eigen::Matrix2i::Identity();
  for (int turns = 0; turns < 4; ++turns, M = quarter * M) {
    const LatticePoint<2> t{101 * turns - 57, 1003};
    const LatticePoint<2> corner_a = M * set.domain().lo + t, corner_b = M * set.domain().hi + t;
    DigitalSet<2> moved({corner_a.cwiseMin(corner_b), corner_a.cwiseMax(corner_b)});
    for_each_point_of(set, [&](const LatticePoint<2>& z) { moved.set(M * z + t, true); });
    Contour turned;
    for (const Surfel<2>& linel : linels) {
      const LatticePoint<2> inner = M * linel.inner + t, normal = M * linel.outer() + t - inner;
      const int axis = normal[0] == 0;
      turned.push_back({inner, std::int8_t(axis), std::int8_t(normal[axis])});
    }
    const Estimates there = eval(moved, turned);
    for (std::size_t c = 0; c < here.columns.size(); ++c) {
      if (is_tangent(here.quantities[c])) continue;
      for (std::size_t i = 0; i < linels.size(); ++i)
        ASSERT_NEAR(there.columns[c][i], here.columns[c][i], 1e-9) << here.quantities[c] << ' ' << i;
    }
    const bool tangents = std::count(here.quantities.begin(), here.quantities.end(), "tangent_x") > 0;
    for (std::size_t i = 0; tangents && i < linels.size(); ++i) {
      const RealPoint<2> a = M.cast<double>() * RealPoint<2>{here["tangent_x"][i], here["tangent_y"][i]};
      ASSERT_NEAR((RealPoint<2>{there["tangent_x"][i], there["tangent_y"][i]} - a).norm(), 0, 1e-9) << i;
    }
  }
}

TEST_P(ContourContract, ScalesLikeACurvature) {
  if (GetParam() == "bc") return;  // its mask size is a function of h, as published
  const auto set = egg();
  const Estimates unit = eval(set, 1), scaled = eval(set, 0.125);
  for (std::size_t c = 0; c < unit.columns.size(); ++c)
    for (std::size_t i = 0; i < unit.columns[c].size(); ++i)
      ASSERT_NEAR(scaled.columns[c][i] * (is_tangent(unit.quantities[c]) ? 1 : 0.125), unit.columns[c][i],
                  1e-9);
}

TEST_P(ContourContract, HasTheSignOfConvexity) {
  // The contour of a disk, and that of the hole in its complement.
  const auto disk = ball_set<2>(40);
  const auto hole = complement(disk, {{-60, -60}, {60, 60}});
  Contour around_hole;
  for (const Surfel<2>& linel : connected_boundary(hole).surfels)
    if (centre(linel, 1).norm() < 45) around_hole.push_back(linel);
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / double(values.size());
  };
  const Estimates inside = eval(disk), outside = eval(hole, around_hole);
  for (std::size_t c = 0; c < inside.columns.size(); ++c)
    if (inside.quantities[c] == "kappa") {
      EXPECT_GT(mean(inside.columns[c]), 0.4 / 40);
      EXPECT_LT(mean(outside.columns[c]), -0.4 / 40);
    }
}

TEST_P(ContourContract, HasUnitTangentsWithTheSetOnTheLeft) {
  const auto set = ball_set<2>(40);
  const Contour linels = connected_boundary(set).surfels;
  const Estimates estimates = eval(set, linels);
  if (std::count(estimates.quantities.begin(), estimates.quantities.end(), "tangent_x") == 0) return;
  const auto points = value_points<2>(variant().position, linels, {1});
  for (std::size_t i = 0; i < linels.size(); ++i) {
    const RealPoint<2> tangent{estimates["tangent_x"][i], estimates["tangent_y"][i]};
    EXPECT_NEAR(tangent.norm(), 1, 1e-12);
    const RealPoint<2> outwards = points[i].normalized();
    EXPECT_GT(tangent.dot(RealPoint<2>{-outwards[1], outwards[0]}), 0.95);
  }
}

TEST_P(ContourContract, RefusesOpenContours) {
  const auto set = egg();
  Contour linels = connected_boundary(set).surfels;
  EXPECT_THROW(eval(set, Contour{linels[0]}), InputError);
  linels.pop_back();
  EXPECT_THROW(eval(set, linels), InputError);
}

TEST_P(ContourContract, MustBeInitialized) {
  const auto set = egg();
  const Contour linels = connected_boundary(set).surfels;
  const auto estimator = variant().make(set, {});
  EXPECT_THROW(estimator->eval(linels), ContractViolation);
  EXPECT_THROW(estimator->init({0}, {1}), ContractViolation);
  EXPECT_THROW(estimator->init({std::nan("")}, {1}), ContractViolation);
  EXPECT_NO_THROW(estimator->init({1}, {0}));
  EXPECT_EQ(estimator->eval(linels).columns[0].size(), linels.size());
  EXPECT_GT(estimator->work().evaluations, 0);
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const EstimatorEntry& entry : estimator_catalogue())
    if (entry.in_2d && !entry.in_2d->takes_radius) result.push_back(entry.name);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, ContourContract, testing::ValuesIn(names()), [](const auto& tested) {
  std::string name = tested.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ContourContract);

}  // namespace
}  // namespace gridstep
