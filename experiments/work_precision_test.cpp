#include "experiments/work_precision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace gridstep {
namespace {

constexpr double kSteps[] = {1, 0.5, 0.25, 0.125, 0.0625, 0.03125};

/// Errors C h^p and times t h^-q.
struct Manufactured {
  std::string estimator;
  double C, p, t, q;
  double noise = 0;
  bool rotated = false;
};

std::vector<WorkPrecision> curves(const std::vector<Manufactured>& all) {
  std::vector<Record> records;
  for (const Manufactured& m : all)
    for (const double h : kSteps)
      for (const std::string evaluation : {"full", "masks"}) {
        Record r;
        r.shape = "disk";
        r.estimator = m.estimator;
        r.noise = m.noise;
        r.rotated = m.rotated;
        r.evaluation = evaluation;
        r.h = h;
        r.k = 1;
        r.surfels = 100;
        r.work.evaluations = 100;
        r.seconds_eval = m.t * std::pow(h, -m.q) * (evaluation == "full" ? 9 : 1);
        const double e = m.C * std::pow(h, m.p);
        r.errors = {{"kappa", {e, e / 2, e / 4, 100}}};
        records.push_back(r);
      }
  return work_precision_of(convergence_of(records, 1), costs_of(records));
}

const Manufactured kSlow{"slow", 1, 0.25, 0.001, 1}, kGood{"good", 1, 0.5, 0.01, 1.5},
    kFlat{"flat", 0.9, 0, 1, 1};

TEST(WorkPrecision, TakesTheFastestEvaluationAndTheMeanError) {
  const auto result = curves({kSlow});
  ASSERT_EQ(result.size(), 3u) << "one a norm";
  ASSERT_EQ(result[0].points.size(), std::size(kSteps));
  for (std::size_t i = 0; i < std::size(kSteps); ++i) {
    EXPECT_EQ(result[0].points[i].h, kSteps[i]);
    EXPECT_NEAR(result[0].points[i].seconds, 0.001 / kSteps[i], 1e-15);
    EXPECT_NEAR(result[0].points[i].error, std::pow(kSteps[i], 0.25), 1e-15);
    EXPECT_NEAR(result[1].points[i].error, std::pow(kSteps[i], 0.25) / 2, 1e-15);
  }
}

TEST(WorkPrecision, TellsRotatedShapesApart) {
  const Manufactured slow{"slow", 2, 0.25, 0.001, 1, 0, true}, good{"good", 2, 0.5, 0.01, 1.5, 0, true};
  const Table table = equal_error_table(curves({kSlow, kGood, slow, good}));
  ASSERT_EQ(table.rows.size(), 18u) << "three norms and steps, twice";
  EXPECT_EQ(table.rows.front()[0], "disk");
  EXPECT_EQ(table.rows.back()[0], "disk, rotated");
}

TEST(WhereReached, InterpolatesPowersExactly) {
  const WorkPrecision curve = curves({kGood})[0];
  for (const double h : {0.9, 0.3, 0.125, 0.032}) {
    EXPECT_NEAR(where_reached(curve, std::sqrt(h), &WorkPrecision::Point::h).value(), h, 1e-12);
    EXPECT_NEAR(where_reached(curve, std::sqrt(h), &WorkPrecision::Point::seconds).value(),
                0.01 * std::pow(h, -1.5), 1e-12);
  }
  EXPECT_EQ(where_reached(curve, 0.9 * std::sqrt(0.03125), &WorkPrecision::Point::h), std::nullopt);
  EXPECT_EQ(where_reached(curve, 2, &WorkPrecision::Point::h), 1) << "at the coarsest step already";
}

TEST(WhereReached, MustStayReached) {
  WorkPrecision curve = curves({kGood})[0];
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    curve.points[i].error = i == 1 ? 0.1 : 1.0 / double(i + 1);
  EXPECT_NEAR(where_reached(curve, 0.25, &WorkPrecision::Point::h).value(), 0.125, 1e-12)
      << "the dip at the second step is luck";
}

std::size_t column(const Table& table, const std::string& title) {
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].title == title) return c;
  ADD_FAILURE() << "no column " << title;
  return 0;
}

TEST(EqualErrorTable, SaysWhichStepTheOthersNeed) {
  const Table table = equal_error_table(curves({kGood, kSlow, kFlat}));
  ASSERT_EQ(table.rows.size(), 3 * 3u) << "three norms at three steps";
  // sup at h = 1/8: h^1/2 = h'^1/4, so h' = h^2 = 1/64, beyond the range; at h = 1 both are 1.
  const auto& coarse = table.rows[0];
  const auto& middle = table.rows[1];
  EXPECT_EQ(coarse[column(table, "slow")], ">= 1");
  EXPECT_EQ(coarse[column(table, "flat")], ">= 1");
  EXPECT_EQ(middle[column(table, "h")], "0.125");
  EXPECT_EQ(middle[column(table, "good")], "0.125");
  EXPECT_EQ(middle[column(table, "slow")], "~0.016");
  EXPECT_EQ(middle[column(table, "flat")], "-") << "does not converge";
}

TEST(WorkPrecisionTable, SaysHowLongEachTakes) {
  const Table table = work_precision_table(curves({kGood, kSlow, kFlat}));
  ASSERT_FALSE(table.rows.empty());
  bool seen = false;
  for (const auto& row : table.rows) {
    ASSERT_EQ(row.size(), table.columns.size());
    if (row[column(table, "norm")] != "sup" || row[column(table, "error")] != "0.5") continue;
    seen = true;
    EXPECT_EQ(row[column(table, "good")], "80 ms") << "h = 1/4";
    EXPECT_EQ(row[column(table, "slow")], "16 ms") << "h = 1/16";
    EXPECT_EQ(row[column(table, "flat")], "-");
  }
  EXPECT_TRUE(seen);
}

TEST(WorkPrecisionTable, ComparesOnlyTheSameNoise) {
  Manufactured noisy = kSlow;
  noisy.noise = 0.2;
  EXPECT_TRUE(work_precision_table(curves({kGood, noisy})).rows.empty()) << "nothing to compare with";
  EXPECT_TRUE(equal_error_table({}).rows.empty());
}

TEST(WorkPrecision, IsWrittenForOtherPrograms) {
  const auto json = to_json(curves({kGood}));
  EXPECT_EQ(json[0]["estimator"], "good");
  EXPECT_EQ(json[0]["norm"], "sup");
  EXPECT_EQ(json[0]["points"].size(), std::size(kSteps));
  EXPECT_EQ(json[0]["points"][1]["h"], 0.5);
}

}  // namespace
}  // namespace gridstep
