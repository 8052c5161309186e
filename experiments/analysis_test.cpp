#include "experiments/analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace gridstep {
namespace {

/// error = h^slope for all shifts but for a few per cent, time = h^-2 (masks) and h^-3 (full).
std::vector<Record> manufactured(double slope, double alpha = 1.0 / 3.0, double noise = 0) {
  std::vector<Record> records;
  for (int level = 0; level < 8; ++level)
    for (int shift = 0; shift < 3; ++shift)
      for (const char* evaluation : {"masks", "full"}) {
        const bool full = evaluation == std::string("full");
        Record record{};
        record.shape = std::string("disk:radius=5");
        record.estimator = std::string("ii");
        record.evaluation = evaluation;
        record.h = std::pow(0.5, level);
        record.k = 3;
        record.alpha = alpha;
        record.noise = noise;
        record.shift = shift;
        record.digital_radius = 3 * std::pow(record.h, alpha - 1);
        record.surfels = 40 << level;
        const double error = std::pow(record.h, slope) * (1 + 0.01 * (shift - 1));
        // The errors of the second evaluation must not count.
        record.errors = {
            {"kappa", {full ? 99.0 : 2 * error, full ? 99.0 : error, full ? 99.0 : 0.8 * error, 40}}};
        record.seconds_eval = std::pow(record.h, full ? -3 : -2) * 1e-3;
        record.work.evaluations = record.surfels;
        record.work.cells_visited =
            std::int64_t(std::pow(record.digital_radius, full ? 2 : 1) * double(record.surfels));
        records.push_back(record);
      }
  return records;
}

TEST(Convergence, RecoversAManufacturedSlopeInEveryNorm) {
  const auto series = convergence_of(manufactured(1.0 / 3.0), 1);
  ASSERT_EQ(series.size(), 3u);
  for (const Convergence& c : series) {
    EXPECT_NEAR(c.fit.slope, 1.0 / 3.0, 1e-12);
    EXPECT_EQ(c.levels.size(), 8u);
    EXPECT_EQ(c.levels.front().errors.size(), 3u);
    EXPECT_EQ(c.verdict, Verdict::consistent);
  }
  EXPECT_EQ(series[0].norm, "sup");
  EXPECT_NEAR(series[0].fit.constant / series[1].fit.constant, 2, 1e-12);
}

TEST(Convergence, JudgesAgainstTheExponentOfTheRadius) {
  EXPECT_EQ(convergence_of(manufactured(0.6), 1)[0].verdict, Verdict::faster);
  EXPECT_EQ(convergence_of(manufactured(0.2), 1)[0].verdict, Verdict::slower);
  EXPECT_EQ(convergence_of(manufactured(0.2, 0.4), 1)[0].verdict, Verdict::consistent);
  EXPECT_EQ(convergence_of(manufactured(-0.4), 1)[0].verdict, Verdict::not_converging);
  EXPECT_FALSE(convergence_of(manufactured(0.1, 0.5), 1)[0].verdict);              // no rate is proven
  EXPECT_FALSE(convergence_of(manufactured(0.3, 1.0 / 3.0, 0.25), 1)[0].verdict);  // nor under noise
}

TEST(Convergence, ProvenExponentIsTheSmallerOfTheTwoErrorTerms) {
  EXPECT_FALSE(proven_exponent(1.0 / 2));
  EXPECT_DOUBLE_EQ(*proven_exponent(2.0 / 5), 1.0 / 5);
  EXPECT_DOUBLE_EQ(*proven_exponent(1.0 / 3), 1.0 / 3);
  EXPECT_DOUBLE_EQ(*proven_exponent(2.0 / 7), 2.0 / 7);
  EXPECT_DOUBLE_EQ(*proven_exponent(1.0 / 4), 1.0 / 4);
}

TEST(Cost, FitsGrowthAndComparesWithTheWholeKernel) {
  const auto costs = costs_of(manufactured(1.0 / 3.0));
  ASSERT_EQ(costs.size(), 2u);
  const auto json = to_json(costs);
  EXPECT_NEAR(json[0]["time_in_h"].get<double>(), -2, 1e-12);
  EXPECT_NEAR(json[1]["time_in_h"].get<double>(), -3, 1e-12);
  EXPECT_NEAR(json[0]["cells_in_radius"].get<double>(), 1, 0.01);
  EXPECT_NEAR(json[1]["cells_in_radius"].get<double>(), 2, 0.01);
  EXPECT_NEAR(json[0]["expected_in_h"].get<double>(), -5.0 / 3.0, 1e-12);  // masks in 2D
  EXPECT_NEAR(json[1]["expected_in_h"].get<double>(), -7.0 / 3.0, 1e-12);  // the whole kernel in 2D
  const Table table = cost_table(costs);
  ASSERT_EQ(table.rows.size(), 2u);
  const std::string speed_up = std::to_string(128) + ".0x";  // h^-1 at h = 2^-7
  EXPECT_NE(std::find(table.rows[0].begin(), table.rows[0].end(), speed_up), table.rows[0].end());
}

TEST(ConvergenceTable, HasARowForEverySeriesAndANoiseColumnWhereThereIsNoise) {
  const Table clean = convergence_table(convergence_of(manufactured(1.0 / 3.0), 1));
  const Table noisy = convergence_table(convergence_of(manufactured(1.0 / 3.0, 1.0 / 3.0, 0.25), 1));
  EXPECT_EQ(clean.rows.size(), 3u);
  EXPECT_EQ(noisy.columns.size(), clean.columns.size() + 1);
  for (const Table& table : {clean, noisy})
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(clean.rows[0].back(), "consistent");
  EXPECT_EQ(noisy.rows[0].back(), "-");
}

}  // namespace
}  // namespace gridstep
