#include <gtest/gtest.h>

#include <numeric>

#include "estimators/catalogue.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {
namespace {

struct Guarded {
  std::vector<double> attempts;
  Estimates estimates, unguarded;
  EstimatorWork work;

  Guarded(const DigitalSet<3>& set, double R) {
    const auto surfels = boundary(set);
    const auto eval = [&](const char* name) {
      auto estimator = find_estimator(name).variant<3>().make(set, {});
      estimator->init({1}, {R});
      estimates = estimator->eval(surfels);
      return estimator;
    };
    eval("ii-ho1");
    unguarded = estimates;
    const auto estimator = eval("ii-ho1-guarded");
    attempts = estimator->raw()["attempt"];
    work = estimator->work();
  }
};

DigitalSet<3> tube(double radius) {
  return set_where<3>({{-30, -12, -12}, {30, 12, 12}},
                      [&](const auto& z) { return z[1] * z[1] + z[2] * z[2] <= radius * radius; });
}

TEST(GuardedHigherOrder, IsHigherOrderWhereTheBallFits) {
  const Guarded guarded(ball_set<3>(20), 9);
  EXPECT_EQ(guarded.work.fallbacks, 0);
  EXPECT_EQ(std::accumulate(guarded.attempts.begin(), guarded.attempts.end(), 0.0), 0);
  EXPECT_TRUE(guarded.estimates.columns == guarded.unguarded.columns);
}

TEST(GuardedHigherOrder, FallsBackWhereTheBallSwallowsATube) {
  // The tube is 9 across: balls of radius 12, 10.7, 9.8 and 8.9 do not fit, and `ii-pf1` has one of 7.1.
  const auto set = tube(4.3);
  const Guarded guarded(set, 12);
  const auto surfels = boundary(set);
  for (std::size_t i = 0; i < surfels.size(); ++i)
    if (std::abs(surfels[i].inner[0]) < 15) {
      EXPECT_EQ(guarded.attempts[i], 4);
      EXPECT_NEAR(guarded.estimates["mean"][i], 1 / 8.6, 0.06);
    }
  EXPECT_GT(guarded.work.fallbacks, std::int64_t(surfels.size() / 2));
}

TEST(GuardedHigherOrder, TakesASmallerBallBeforeAnotherKernel) {
  // The tube is 14 to 15 across: 1.13 times 15.7, 14.0 and 12.8 is more, mostly, and times 11.6 less.
  const auto set = tube(7);
  const Guarded guarded(set, 15.7);
  const auto surfels = boundary(set);
  int inner = 0, smaller = 0;
  for (std::size_t i = 0; i < surfels.size(); ++i)
    if (std::abs(surfels[i].inner[0]) < 12) {
      ++inner;
      EXPECT_GT(guarded.attempts[i], 0);
      smaller += guarded.attempts[i] == 3;
    }
  EXPECT_GT(smaller, 0.9 * inner);
}

}  // namespace
}  // namespace gridstep
