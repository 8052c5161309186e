#include "shapes/digital/brick_levels.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <vector>

#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

/// Terms of all sizes, down to none at all, that add up to at most 1 in absolute value at every point of the brick.
template <int d>
BrickLevels<d> random_levels(RandomStream& random) {
  std::array<int, d> most;
  for (int k = 0; k < d; ++k) most[std::size_t(k)] = Brick<d>::extent(k) - 1;
  double sum = 0;
  const auto term = [&](int greatest_factor) {
    const double size = random.below(4) == 0 ? 0 : std::exp2(-30 * random.uniform());
    sum += size;
    return (random.below(2) == 0 ? size : -size) / greatest_factor;
  };
  std::array<double, 1 + d + d*(d + 1) / 2> terms;
  std::size_t next = 0;
  terms[next++] = term(1);
  for (std::size_t k = 0; k < d; ++k) terms[next++] = term(most[k]);
  for (std::size_t j = 0; j < d; ++j)
    for (std::size_t k = j; k < d; ++k) terms[next++] = term(most[j] * most[k]);
  for (double& one : terms) one /= std::max(sum, 1e-30) * (1 + 1e-6);

  BrickLevels<d> levels;
  next = 0;
  levels.constant = float(terms[next++]);
  for (float& linear : levels.linear) linear = float(terms[next++]);
  for (float& square : levels.square) square = float(terms[next++]);
  return levels;
}

template <int d>
double level_at(const BrickLevels<d>& levels, const LatticePoint<d>& n) {
  double level = levels.constant;
  std::size_t pair = 0;
  for (int j = 0; j < d; ++j) {
    level += double(levels.linear[std::size_t(j)]) * n[j];
    for (int k = j; k < d; ++k) level += double(levels.square[pair++]) * n[j] * n[k];
  }
  return level;
}

/// With each instruction set that was compiled and that this processor has.
template <int d>
void compare_with_the_definition() {
  RandomStream random{1};
  for (int trial = 0; trial < 2000; ++trial) {
    const BrickLevels<d> levels = random_levels<d>(random);
    const auto within = float(random.below(3) == 0 ? 0 : std::exp2(-20 * random.uniform()));
    std::vector<ComparedLevels<d>> results;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::GetChosenTarget().Update(target);
      results.push_back(compare(levels, within));
    }
    hwy::GetChosenTarget().DeInit();
    ASSERT_FALSE(results.empty());
    for (const ComparedLevels<d>& result : results) {
      EXPECT_EQ(result.below, results[0].below);
      EXPECT_EQ(result.above, results[0].above);
    }
    int wrong = 0;
    for (int bit = 0; bit < Brick<d>::kBits; ++bit) {
      const double level = level_at(levels, Brick<d>::offset(bit)), off = BrickLevels<d>::kRounding;
      const bool below = results[0].below.test(bit), above = results[0].above.test(bit);
      wrong += (level < -within - off && !below) || (level > -within + off && below);
      wrong += (level > within + off && !above) || (level < within - off && above);
    }
    ASSERT_EQ(wrong, 0) << "trial " << trial;
  }
}

TEST(BrickLevels, AreComparedAsDefinedOnEveryProcessor) {
  compare_with_the_definition<2>();
  compare_with_the_definition<3>();
}

TEST(BrickLevels, PointsOnTheLevelAreNeitherBelowNorAbove) {
  const BrickLevels<3> levels{-0.5f, {0.125f, 0, 0}, {}};
  const auto [below, above] = compare(levels, 0.25f);
  for (int bit = 0; bit < Brick<3>::kBits; ++bit) {
    const int x = Brick<3>::offset(bit)[0];  // of level (x - 4) / 8
    EXPECT_EQ(below.test(bit), x < 2);
    EXPECT_EQ(above.test(bit), x > 6);
  }
}

}  // namespace
}  // namespace gridstep
