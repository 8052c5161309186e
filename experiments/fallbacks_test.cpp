#include "experiments/fallbacks.hpp"

#include <gtest/gtest.h>

namespace gridstep {
namespace {

Record record(const std::string& estimator, double h, std::int64_t fallbacks, double noise = 0) {
  Record r;
  r.shape = "torus";
  r.estimator = estimator;
  r.evaluation = "bricks";
  r.k = 6.75;
  r.alpha = 1.0 / 3;
  r.h = h;
  r.noise = noise;
  r.surfels = 100;
  r.work.fallbacks = fallbacks;
  return r;
}

TEST(Fallbacks, AreSummedUpOverTheShiftsAtEachStep) {
  const auto result = fallbacks_of({record("plain", 0.25, 0), record("guarded", 0.25, 3),
                                    record("guarded", 0.5, 100), record("guarded", 0.25, 4)});
  ASSERT_EQ(result.size(), 1u) << "the other one has no guard, or had no need of it";
  EXPECT_EQ(result[0].estimator, "guarded");
  ASSERT_EQ(result[0].by_step.size(), 2u);
  EXPECT_EQ(result[0].by_step.begin()->first, 0.5) << "from coarse to fine";
  EXPECT_EQ(result[0].by_step.at(0.5).fallbacks, 100);
  EXPECT_EQ(result[0].by_step.at(0.25).fallbacks, 7);
  EXPECT_EQ(result[0].by_step.at(0.25).surfels, 200);
}

TEST(Fallbacks, CountOneEvaluationOnly) {
  Record full = record("guarded", 0.5, 5);
  full.evaluation = "full";
  const auto result = fallbacks_of({record("guarded", 0.5, 5), full});
  ASSERT_EQ(result.size(), 1u);
  EXPECT_EQ(result[0].by_step.at(0.5).fallbacks, 5);
  EXPECT_EQ(result[0].by_step.at(0.5).surfels, 100);
}

TEST(Fallbacks, AreListedStepByStep) {
  const Table table = fallback_table(
      fallbacks_of({record("guarded", 0.5, 100), record("guarded", 0.25, 7), record("guarded", 0.125, 0)}));
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"torus", "guarded", "6.75 h^0.333",
                                                     "0.5: 100 of 100, 0.25: 7 of 100, 0.125: none"}));
}

TEST(Fallbacks, TellNoiseApart) {
  const Table table =
      fallback_table(fallbacks_of({record("guarded", 0.5, 1), record("guarded", 0.5, 2, 0.3)}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0][1], "0");
  EXPECT_EQ(table.rows[1][1], "0.3");
}

TEST(Fallbacks, AreNoneWithoutAGuard) {
  EXPECT_TRUE(fallbacks_of({record("plain", 0.5, 0)}).empty());
  EXPECT_TRUE(fallback_table({}).rows.empty());
}

}  // namespace
}  // namespace gridstep
