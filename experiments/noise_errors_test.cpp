#include "experiments/noise_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gridstep {
namespace {

/// Errors (1 + 10 beta) h^p, with p = 1/2 without noise and -1/2 with it.
std::vector<Record> records(const std::vector<double>& betas,
                            const std::vector<double>& steps = {1, 0.64, 0.36, 0.16, 0.09, 0.04}) {
  std::vector<Record> result;
  for (const double beta : betas)
    for (const double h : steps)
      for (const int shift : {0, 1}) {
        Record r;
        r.shape = "disk";
        r.estimator = std::string("bc");
        r.noise = beta;
        r.h = h;
        r.shift = shift;
        r.surfels = 10;
        const double error = (1 + 10 * beta) * std::pow(h, beta > 0 ? -0.5 : 0.5) * (shift ? 1.01 : 0.99);
        r.errors = {{"kappa", {error, error, error, 10}}};
        result.push_back(r);
      }
  return result;
}

std::vector<NoiseErrors> entries(const std::vector<double>& betas) {
  return noise_errors_of(convergence_of(records(betas), 1));
}

TEST(NoiseErrors, AreMeansAtTheFinestStepByBeta) {
  const auto result = entries({0.3, 0, 0.1});
  ASSERT_EQ(result.size(), 3u) << "one a norm";
  for (const NoiseErrors& entry : result) {
    EXPECT_EQ(entry.h, 0.04);
    EXPECT_EQ(entry.noise, 0);
    ASSERT_EQ(entry.levels.size(), 3u);
    EXPECT_EQ(entry.levels[0].beta, 0);
    EXPECT_NEAR(entry.levels[0].error, 0.2, 1e-12);
    EXPECT_EQ(entry.levels[1].beta, 0.1);
    EXPECT_NEAR(entry.levels[1].error, 2 * 5, 1e-12);
    EXPECT_EQ(entry.levels[2].beta, 0.3);
    EXPECT_NEAR(entry.levels[2].error, 4 * 5, 1e-12);
  }
}

TEST(NoiseErrors, AreMarkedWhereTheyDoNotFall) {
  const Table table = noise_table(entries({0, 0.1}));
  ASSERT_EQ(table.columns.size(), 8u);
  EXPECT_EQ(table.columns[7].title, "0.1");
  EXPECT_EQ(table.rows[0][6], "0.2");
  EXPECT_EQ(table.rows[0][7], "10*");
}

TEST(NoiseErrors, AreMarkedWhereTooFewStepsTell) {
  const auto few = noise_errors_of(convergence_of(records({0, 0.1}, {1, 0.04}), 1));
  EXPECT_EQ(noise_table(few).rows[0][7], "10?");
}

TEST(NoiseErrors, LeaveOutALevelThatASeriesDoesNotHave) {
  auto all = records({0, 0.1});
  for (Record r : records({0.1, 0.4})) {
    r.shape = "square";
    all.push_back(r);
  }
  const Table table = noise_table(noise_errors_of(convergence_of(all, 1)));
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_EQ(table.rows[0][8], "");
  EXPECT_EQ(table.rows[3][6], "");
  EXPECT_EQ(table.rows[3][8], "25*");
}

TEST(NoiseErrors, NeedSeveralLevels) {
  EXPECT_TRUE(entries({0.2}).empty());
}

}  // namespace
}  // namespace gridstep
