#include "estimators/integral_invariant/radial/radial_sums.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {
namespace {

RadialKernels kernels(int d) {
  return {vanishing_kernel(d, 1, std::array{0, 4}), vanishing_kernel(d, 1, std::array{4}),
          vanishing_kernel(3, 1, std::array{6})};
}

template <int d>
std::vector<RadialSum> sums(const DigitalSet<d>& set, double radius, Evaluation evaluation) {
  RadialSums<d> sums(set, kernels(d), evaluation);
  sums.init({1}, {radius});
  const auto surfels = boundary(set);
  return sums.eval(surfels);
}

/// Full, empty and mixed bricks, and points on the border of the domain.
template <int d>
std::vector<DigitalSet<d>> sets() {
  std::vector<DigitalSet<d>> result;
  for (const double density : {0.02, 0.5, 0.98})
    result.push_back(
        random_set<d>({LatticePoint<d>::Constant(-13), LatticePoint<d>::Constant(20)}, density, 5));
  result.push_back(ball_set<d>(23));
  result.push_back(set_where<d>({LatticePoint<d>::Constant(0), LatticePoint<d>::Constant(40)},
                                [](const LatticePoint<d>& z) { return z.sum() < 41; }));
  return result;
}

template <int d>
void expect_bricks_equal_full(const std::vector<double>& radii) {
  for (const DigitalSet<d>& set : sets<d>())
    for (const double radius : radii) {
      const auto expected = sums<d>(set, radius, Evaluation::full);
      ASSERT_FALSE(expected.empty());
      EXPECT_TRUE(sums<d>(set, radius, Evaluation::bricks) == expected) << radius;
    }
}

TEST(RadialSums, BricksGiveTheIntegersOfTheFullKernelIn2D) {
  expect_bricks_equal_full<2>({1, 2.5, 8, 17.3, 40});
}

TEST(RadialSums, BricksGiveTheIntegersOfTheFullKernelIn3D) {
  expect_bricks_equal_full<3>({1, 3, 6.5, 9});
}

TEST(RadialSums, DoNotDependOnTheNumberOfThreads) {
  const auto set = ball_set<3>(20);
  const auto expected = sums<3>(set, 11.5, Evaluation::bricks);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_TRUE(sums<3>(set, 11.5, Evaluation::bricks) == expected);
}

TEST(RadialSums, AreTheSameWithoutATensor) {
  for (const auto& set : sets<3>()) {
    const auto expected = sums<3>(set, 6.5, Evaluation::full);
    RadialSums<3> radial(set, kernels(3), Evaluation::bricks, false);
    radial.init({1}, {6.5});
    const auto surfels = boundary(set);
    const auto own = radial.eval(surfels);
    for (std::size_t i = 0; i < own.size(); ++i)
      ASSERT_TRUE(own[i] == (RadialSum{expected[i].trace, expected[i].edge, {}, {}})) << i;
  }
}

TEST(RadialSums, OfAHalfSpaceAreHalfOfTheWhole) {
  // The boundary is half a cell from the centres of its surfels' inner spels: no lattice point is on it.
  const auto set = set_where<3>({LatticePoint<3>::Constant(-20), LatticePoint<3>::Constant(20)},
                                [](const LatticePoint<3>& z) { return z[2] <= 0; });
  RadialSums<3> radial(set, kernels(3), Evaluation::bricks);
  radial.init({1}, {9.2});
  const Surfel<3> surfel{{0, 0, 0}, 2, 1};
  const RadialSum sum = radial.eval({&surfel, 1}).front(), whole = radial.whole(2);
  EXPECT_EQ(2 * sum.trace, whole.trace);
  EXPECT_EQ(2 * sum.edge, whole.edge);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(2 * sum.tensor_second[i], whole.tensor_second[i]);
  EXPECT_EQ(sum.edge_first[0], 0);
  EXPECT_LT(sum.edge_first[2], 0);
}

TEST(RadialSums, RefuseARadiusWithoutTables) {
  const auto set = ball_set<3>(4);
  EXPECT_THROW(sums<3>(set, 0.9, Evaluation::bricks), InputError);
  EXPECT_THROW(sums<3>(set, RadialBricks<WholeFlux>::kGreatestRadius + 1, Evaluation::bricks), InputError);
}

TEST(RadialWeight, IsRoundedByHalfAUnitAtMost) {
  const DigitalLength radius{12.3};
  const RadialKernel kernel = vanishing_kernel(3, 1, std::array{0, 4});
  const RadialWeight weight(kernel, radius);
  for (std::int64_t squared = 0; squared <= 605; ++squared)
    EXPECT_NEAR(double(weight(squared)) * weight.unit(), kernel(double(squared) / (4 * 12.3 * 12.3)),
                weight.unit() * (0.5 + 1e-9));
  EXPECT_LE(std::abs(weight(0)), 1 << 20);
}

}  // namespace
}  // namespace gridstep
