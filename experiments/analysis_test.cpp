#include "experiments/analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace gridstep {
namespace {

using nlohmann::ordered_json;

constexpr double kSteps[] = {1, 0.6, 0.4, 0.25, 0.15, 0.1, 0.06, 0.04};

/// Errors C h^p with C = 3, 2, 1 for sup, rms, mean, and costs c h^-2 and c h^-1.5 of the whole kernel and of
/// masks; the shifts differ by a factor that is the same at every step, which leaves slopes alone.
struct Manufactured {
  std::string shape = "disk:radius=5", estimator = "ii", centre = "spels";
  double p = 1.0 / 3.0, k = 5, alpha = 1.0 / 3.0, noise = 0;
  std::vector<std::string> evaluations{"full", "masks"};
  std::vector<double> steps{std::begin(kSteps), std::end(kSteps)};
  int dimension = 2;
  bool rotated = false;
};

constexpr double kFactors[] = {0.5, 1, 4};

std::vector<Record> records(const Manufactured& m) {
  std::vector<Record> result;
  for (const double h : m.steps)
    for (int shift = 0; shift < 3; ++shift)
      for (const std::string& evaluation : m.evaluations) {
        Record r;
        r.shape = m.shape;
        r.estimator = m.estimator;
        r.evaluation = evaluation;
        r.centre = m.centre;
        r.dimension = m.dimension;
        r.h = h;
        r.k = m.k;
        r.alpha = m.alpha;
        r.noise = m.noise;
        r.rotated = m.rotated;
        r.shift = shift;
        r.offset.assign(std::size_t(m.dimension), 0.1 * shift);
        r.digital_radius = m.k * std::pow(h, m.alpha) / h;
        r.surfels = 1000;
        r.components = 1;
        const double error = kFactors[shift] * std::pow(h, m.p);
        r.errors = {{"kappa", {3 * error, 2 * error, error, 1000}}};
        r.work.evaluations = 500;
        r.work.restarts = 5;
        const double power = evaluation == "full" ? 2 : 1.5;
        r.work.cells_visited = std::int64_t(std::llround(1e6 * std::pow(h, -power)));
        r.seconds_init = 0.25 * kFactors[shift];
        r.seconds_eval = kFactors[shift] * (evaluation == "full" ? 0.08 : 0.02) * std::pow(h, -power);
        result.push_back(r);
      }
  return result;
}

std::vector<Record> operator+(std::vector<Record> a, const std::vector<Record>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::size_t column(const Table& table, const std::string& title, std::size_t which = 0) {
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].title == title && which-- == 0) return c;
  ADD_FAILURE() << "no column " << title;
  return 0;
}

TEST(ProvenExponent, IsTheSmallerOfTwoTerms) {
  EXPECT_EQ(proven_exponent(0.5), std::nullopt) << "1 - 2 alpha = 0: the digitization term does not vanish";
  EXPECT_NEAR(proven_exponent(2.0 / 5).value(), 1.0 / 5, 1e-15);
  EXPECT_NEAR(proven_exponent(1.0 / 3).value(), 1.0 / 3, 1e-15);
  EXPECT_NEAR(proven_exponent(2.0 / 7).value(), 2.0 / 7, 1e-15);
  EXPECT_NEAR(proven_exponent(1.0 / 4).value(), 1.0 / 4, 1e-15);
  EXPECT_EQ(proven_exponent(0), std::nullopt);
  EXPECT_EQ(proven_exponent(0.9), std::nullopt);
}

TEST(ConvergenceOf, RecoversManufacturedSlopes) {
  const auto series = convergence_of(records({}), 1);
  ASSERT_EQ(series.size(), 3u) << "one a norm; evaluations have the same errors";
  const char* const norms[] = {"sup", "rms", "mean"};
  const double middle = std::cbrt(0.5 * 1 * 4);  // of the shifts, in the mean of the logarithms
  for (int i = 0; i < 3; ++i) {
    const Convergence& c = series[std::size_t(i)];
    EXPECT_EQ(c.shape, "disk:radius=5");
    EXPECT_EQ(c.estimator, "ii");
    EXPECT_EQ(c.quantity, "kappa");
    EXPECT_EQ(c.norm, norms[i]);
    EXPECT_EQ(c.k, 5);
    EXPECT_EQ(c.noise, 0);
    ASSERT_EQ(c.levels.size(), std::size(kSteps));
    for (const Level& level : c.levels) EXPECT_EQ(level.errors.size(), 3u) << "one a shift";
    EXPECT_NEAR(c.fit.slope, 1.0 / 3, 1e-12);
    EXPECT_NEAR(c.fit.constant, (3 - i) * middle, 1e-12);
    EXPECT_NEAR(c.fit.theil_sen, 1.0 / 3, 1e-12);
    EXPECT_NEAR(c.fit.envelope_slope, 1.0 / 3, 1e-12);
    EXPECT_NEAR(c.expected.value(), 1.0 / 3, 1e-15);
    EXPECT_EQ(c.verdict, Verdict::consistent);
  }
}

TEST(ConvergenceOf, JudgesAgainstTheExponentOfTheRadius) {
  const auto verdict = [](double p, double alpha) {
    return convergence_of(records({.p = p, .alpha = alpha}), 1).front().verdict;
  };
  EXPECT_EQ(verdict(0.25, 0.25), Verdict::consistent);
  EXPECT_EQ(verdict(0.5, 0.25), Verdict::faster);
  EXPECT_EQ(verdict(0.25, 1.0 / 3), Verdict::slower);
  EXPECT_EQ(verdict(0, 1.0 / 3), Verdict::not_converging);
  EXPECT_EQ(verdict(-0.5, 0.4), Verdict::not_converging);
  EXPECT_EQ(verdict(0.2, 0.4), Verdict::consistent);
  EXPECT_EQ(verdict(0.5, 0.5), Verdict::converging) << "no theorem";
  EXPECT_EQ(verdict(0.01, 0.5), Verdict::not_converging);
}

TEST(ConvergenceOf, HoldsNoTheoremAgainstNoise) {
  for (const Convergence& c : convergence_of(records({.noise = 0.1}), 1)) {
    EXPECT_NEAR(c.fit.slope, 1.0 / 3, 1e-12);
    EXPECT_EQ(c.expected, std::nullopt);
    EXPECT_EQ(c.verdict, Verdict::converging);
  }
}

TEST(ConvergenceOf, TakesTheTheoremFromTheCatalogue) {
  std::vector<Record> all = records({.estimator = "ii-covariance", .p = 0.25, .dimension = 3});
  for (Record& r : all) r.errors = {{"k1", r.errors[0].second}, {"normal", r.errors[0].second}};
  const auto series = convergence_of(all, 1);
  EXPECT_NEAR(series[0].expected.value(), 1.0 / 3, 1e-15);
  EXPECT_EQ(series[0].verdict, Verdict::slower);
  EXPECT_EQ(series[3].expected, std::nullopt) << "none on normals";
  EXPECT_EQ(series[3].verdict, Verdict::converging);
}

TEST(ConvergenceOf, KnowsEstimatorsWithoutARadius) {
  const auto series =
      convergence_of(records({.estimator = "bc", .k = 0, .alpha = 0, .evaluations = {""}}), 1);
  ASSERT_EQ(series.size(), 3u);
  EXPECT_EQ(series[0].verdict, Verdict::converging);
  const Table table = convergence_table(series);
  EXPECT_EQ(table.rows[0][column(table, "R")], "-");
}

TEST(ConvergenceOf, KeepsSeriesApartInTheOrderOfTheRecords) {
  const std::vector<Record> all =
      records({.shape = "b"}) + records({.shape = "a"}) + records({.shape = "a", .estimator = "other"}) +
      records({.shape = "a", .k = 3}) + records({.shape = "a", .alpha = 0.25}) +
      records({.shape = "a", .noise = 0.1}) + records({.shape = "a", .centre = "surfel"}) +
      records({.shape = "a", .rotated = true});
  const auto series = convergence_of(all, 1);
  ASSERT_EQ(series.size(), 8 * 3u);
  for (const Convergence& c : series) {
    EXPECT_EQ(c.levels.size(), std::size(kSteps));
    for (const Level& level : c.levels) EXPECT_EQ(level.errors.size(), 3u);
  }
  EXPECT_EQ(series[0].shape, "b");
  EXPECT_EQ(series[3].shape, "a");
  EXPECT_EQ(series[6].estimator, "other");
  EXPECT_EQ(series[9].k, 3);
  EXPECT_EQ(series[12].alpha, 0.25);
  EXPECT_EQ(series[15].noise, 0.1);
  EXPECT_EQ(series[18].centre, "surfel");
  EXPECT_TRUE(series[21].rotated);
}

TEST(ConvergenceOf, MergesStepsOfSeveralSweepsAndEvaluations) {
  // The whole kernel at coarse steps, masks at fine ones; and listed from fine to coarse.
  const std::vector<Record> all = records({.evaluations = {"masks"}, .steps = {0.25, 0.1, 0.05}}) +
                                  records({.evaluations = {"full", "masks"}, .steps = {1, 0.5}});
  const auto series = convergence_of(all, 1);
  ASSERT_EQ(series.size(), 3u);
  ASSERT_EQ(series[0].levels.size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_LT(series[0].levels[i].h, series[0].levels[i - 1].h);
  for (const Level& level : series[0].levels) EXPECT_EQ(level.errors.size(), 3u);
  EXPECT_NEAR(series[0].fit.slope, 1.0 / 3, 1e-12);
}

TEST(ConvergenceOf, HasOneSeriesForEachQuantity) {
  std::vector<Record> all = records({.evaluations = {"masks"}});
  for (Record& r : all) r.errors = {{"k1", {1, 1, 1, 5}}, {"k2", {r.h, r.h, r.h, 5}}};
  const auto series = convergence_of(all, 1);
  ASSERT_EQ(series.size(), 6u);
  EXPECT_EQ(series[0].quantity, "k1");
  EXPECT_NEAR(series[0].fit.slope, 0, 1e-12);
  EXPECT_EQ(series[3].quantity, "k2");
  EXPECT_NEAR(series[3].fit.slope, 1, 1e-12);
}

TEST(ConvergenceOf, TakesWhatThereIs) {
  EXPECT_TRUE(convergence_of({}, 1).empty());
  std::vector<Record> all = records({.steps = {1, 0.5}});
  for (Record& r : all)
    if (r.h == 1) r.errors.clear();  // no surfel with a truth
  const auto series = convergence_of(all, 1);
  ASSERT_EQ(series.size(), 3u);
  EXPECT_FALSE(series[0].fit.fitted);
  EXPECT_EQ(series[0].verdict, Verdict::undecided);
  EXPECT_EQ(convergence_table(series).rows[0][column(convergence_table(series), "slope")], "-");
}

TEST(ConvergenceTable, ShowsErrorsSlopesAndVerdicts) {
  const Table table = convergence_table(convergence_of(records({}), 1));
  ASSERT_EQ(table.rows.size(), 3u);
  const auto& row = table.rows[0];
  ASSERT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(row[column(table, "shape")], "disk:radius=5");
  EXPECT_EQ(row[column(table, "R")], "5 h^0.333");
  EXPECT_EQ(row[column(table, "norm")], "sup");
  EXPECT_EQ(row[column(table, "h")], "1");
  EXPECT_EQ(row[column(table, "error")], "5.500") << "3 (0.5 + 1 + 4)/3";
  EXPECT_EQ(row[column(table, "h", 1)], "0.04");
  EXPECT_EQ(row[column(table, "error", 1)], "1.881") << "5.5 cbrt(0.04)";
  EXPECT_EQ(row[column(table, "slope")], "0.333");
  EXPECT_EQ(row[column(table, "95 %")], "[0.333, 0.333]");
  EXPECT_EQ(row[column(table, "robust")], "0.333");
  EXPECT_EQ(row[column(table, "envelope")], "0.333");
  EXPECT_EQ(row[column(table, "theory")], "0.333");
  EXPECT_EQ(row[column(table, "verdict")], "consistent");
}

TEST(ConvergenceTable, TellsRotatedShapesApart) {
  const auto series = convergence_of(records({}) + records({.rotated = true}), 1);
  const Table table = convergence_table(series);
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_EQ(table.rows[0][column(table, "shape")], "disk:radius=5");
  EXPECT_EQ(table.rows[3][column(table, "shape")], "disk:radius=5, rotated");
}

TEST(ConvergenceTable, HasColumnsForNoiseAndCentreWhereTheyDiffer) {
  const auto titles = [](const Table& table) {
    std::vector<std::string> result;
    for (const Column& c : table.columns) result.push_back(c.title);
    return result;
  };
  const auto has = [&](const Table& table, const std::string& title) {
    const auto all = titles(table);
    return std::find(all.begin(), all.end(), title) != all.end();
  };
  const Table plain = convergence_table(convergence_of(records({}), 1));
  EXPECT_FALSE(has(plain, "noise"));
  EXPECT_FALSE(has(plain, "centre"));
  const Table both =
      convergence_table(convergence_of(records({}) + records({.centre = "surfel", .noise = 0.25}), 1));
  ASSERT_EQ(both.rows.size(), 6u);
  EXPECT_EQ(both.rows[0][column(both, "noise")], "0");
  EXPECT_EQ(both.rows[3][column(both, "noise")], "0.25");
  EXPECT_EQ(both.rows[3][column(both, "theory")], "-");
  EXPECT_EQ(both.rows[3][column(both, "verdict")], "converging");
  EXPECT_EQ(both.rows[0][column(both, "centre")], "spels");
  EXPECT_EQ(both.rows[3][column(both, "centre")], "surfel");
  EXPECT_EQ(both.rows[3][column(both, "norm")], "sup");
  EXPECT_NO_THROW(to_text(both));
  const Table costs = cost_table(costs_of(records({}) + records({.centre = "surfel"})));
  EXPECT_EQ(costs.rows.at(2)[column(costs, "centre")], "surfel");
  EXPECT_EQ(costs.rows.at(2)[column(costs, "evaluation")], "full");
  EXPECT_NO_THROW(to_text(costs));
}

TEST(CostsOf, TakesMediansOverShifts) {
  const auto costs = costs_of(records({}));
  ASSERT_EQ(costs.size(), 2u);
  EXPECT_EQ(costs[0].evaluation, "full");
  EXPECT_EQ(costs[1].evaluation, "masks");
  ASSERT_EQ(costs[0].steps.size(), std::size(kSteps));
  const Cost::Step& finest = costs[0].steps.back();
  EXPECT_EQ(finest.h, 0.04);
  EXPECT_NEAR(finest.seconds_eval, 0.08 / 0.0016, 1e-9) << "of factors 0.5, 1, 4, whose mean is 1.83";
  EXPECT_NEAR(finest.seconds_init, 0.25, 1e-12);
  EXPECT_EQ(finest.cells_visited, 625e6);
  EXPECT_EQ(finest.surfels, 1000);
  EXPECT_EQ(finest.restarts, 5);
  EXPECT_EQ(finest.evaluations, 500);
  EXPECT_NEAR(finest.digital_radius, 5 * std::pow(0.04, -2.0 / 3), 1e-12);
}

TEST(CostsOf, KeepNoiseApartAndTheTableLeavesItOut) {
  const auto costs = costs_of(records({}) + records({.noise = 0.1}));
  ASSERT_EQ(costs.size(), 4u);
  EXPECT_EQ(costs[2].noise, 0.1);
  EXPECT_EQ(cost_table(costs).rows.size(), 2u);
}

TEST(CostTable, ShowsGrowthAndSpeedUp) {
  const Table table = cost_table(costs_of(records({})));
  ASSERT_EQ(table.rows.size(), 2u);
  const auto cell = [&](std::size_t row, const char* title) { return table.rows[row][column(table, title)]; };
  EXPECT_EQ(cell(0, "time~h"), "-2.00");
  EXPECT_EQ(cell(1, "time~h"), "-1.50");
  EXPECT_EQ(cell(0, "cells~h"), "-2.00");
  EXPECT_EQ(cell(1, "cells~h"), "-1.50");
  EXPECT_EQ(cell(0, "theory"), "-2.33") << "h^-1 surfels times (R/h)^2, R = k h^(1/3)";
  EXPECT_EQ(cell(1, "theory"), "-1.67");
  EXPECT_EQ(cell(0, "cells~R/h"), "3.00") << "h^-2 is (R/h)^3, as R/h = k h^(-2/3)";
  EXPECT_EQ(cell(1, "time~R/h"), "2.25");
  EXPECT_EQ(cell(0, "vs full"), "-");
  EXPECT_EQ(cell(1, "vs full"), "20.0x") << "4 h^-0.5 at h = 0.04";
  EXPECT_EQ(cell(0, "surfels"), "1000");
  EXPECT_EQ(cell(0, "restarts"), "1.00 %");
  EXPECT_EQ(cell(0, "ns/surfel"), "50000000");
  EXPECT_EQ(cell(0, "cells/surfel"), "625000");
}

TEST(CostTable, ExpectsMoreIn3D) {
  const Table table = cost_table(costs_of(records({.dimension = 3})));
  EXPECT_EQ(table.rows[0][column(table, "theory")], "-4.00");
  EXPECT_EQ(table.rows[1][column(table, "theory")], "-3.33");
}

TEST(CostTable, ComparesTimesAtTheSameStepAlone) {
  const Table table = cost_table(costs_of(records({.evaluations = {"full"}, .steps = {1, 0.5}}) +
                                          records({.evaluations = {"masks"}, .steps = {1, 0.5, 0.25}})));
  EXPECT_EQ(table.rows.at(1)[column(table, "vs full")], "-");
}

TEST(CostTable, HasNoGrowthFromOneStep) {
  const Table table = cost_table(costs_of(records({.steps = {0.5}})));
  EXPECT_EQ(table.rows.at(0)[column(table, "time~h")], "-");
  EXPECT_EQ(table.rows.at(0)[column(table, "cells~R/h")], "-");
}

/// JSON has no infinity: the library writes null for one, so a null that is not documented is a lost number.
void expect_no_null(const ordered_json& json, const std::vector<std::string>& may_be_null) {
  const ordered_json flat = json.flatten();
  for (const auto& [path, value] : flat.items()) {
    bool allowed = false;
    for (const std::string& key : may_be_null) allowed = allowed || path.find("/" + key) != std::string::npos;
    EXPECT_TRUE(allowed || !value.is_null()) << path;
  }
}

TEST(ConvergenceJson, IsCompleteAndFinite) {
  const ordered_json json = to_json(convergence_of(records({}) + records({.alpha = 0.5}), 1));
  ASSERT_EQ(json.size(), 6u);
  const ordered_json& c = json[0];
  EXPECT_EQ(c.at("shape"), "disk:radius=5");
  EXPECT_EQ(c.at("centre"), "spels");
  EXPECT_EQ(c.at("norm"), "sup");
  EXPECT_NEAR(c.at("slope").get<double>(), 1.0 / 3, 1e-12);
  EXPECT_NEAR(c.at("expected").get<double>(), 1.0 / 3, 1e-12);
  EXPECT_EQ(c.at("verdict"), "consistent");
  EXPECT_EQ(c.at("zero_errors"), 0);
  ASSERT_EQ(c.at("levels").size(), std::size(kSteps));
  EXPECT_EQ(c.at("levels")[7].at("h"), 0.04);
  EXPECT_EQ(c.at("levels")[7].at("errors").size(), 3u);
  EXPECT_EQ(c.at("scan").size(), 4u);
  EXPECT_EQ(c.at("scan")[3].at("dropped"), 3);
  EXPECT_EQ(c.at("pairwise").size(), 7u);
  EXPECT_NEAR(c.at("pairwise")[0].at("order").get<double>(), 1.0 / 3, 1e-12);
  expect_no_null(json[0], {});
  EXPECT_EQ(json[3].at("verdict"), "converging");
  expect_no_null(json[3], {"expected"});
  EXPECT_EQ(ordered_json::parse(json.dump()), json);
  // Too few levels for an interval: null, never an invalid number.
  const ordered_json few = to_json(convergence_of(records({.steps = {1, 0.5}}), 1));
  EXPECT_EQ(few[0].at("interval"), ordered_json::parse("[null, null]"));
  EXPECT_EQ(ordered_json::parse(few.dump()), few);
}

TEST(CostJson, IsCompleteAndFinite) {
  const ordered_json json = to_json(costs_of(records({})));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0].at("evaluation"), "full");
  EXPECT_EQ(json[0].at("centre"), "spels");
  EXPECT_NEAR(json[0].at("time_in_h").get<double>(), -2, 1e-9);
  EXPECT_NEAR(json[1].at("cells_in_h").get<double>(), -1.5, 1e-6);
  EXPECT_NEAR(json[0].at("expected_in_h").get<double>(), -7.0 / 3, 1e-12);
  EXPECT_NEAR(json[0].at("cells_in_radius").get<double>(), 3, 1e-6);
  EXPECT_NEAR(json[1].at("time_in_radius").get<double>(), 2.25, 1e-6);
  EXPECT_EQ(json[0].at("steps").size(), std::size(kSteps));
  expect_no_null(json, {});
  EXPECT_TRUE(to_json(costs_of(records({.steps = {0.5}})))[0].at("time_in_h").is_null());
}

}  // namespace
}  // namespace gridstep
