#include "experiments/report/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/core/testing_files.hpp"
#include "experiments/report/base64.hpp"
#include "experiments/report/surface_json.hpp"
#include "experiments/runner.hpp"

namespace gridstep {
namespace {

std::vector<Record> records_of(const nlohmann::json& sweep) {
  const nlohmann::json study{{"name", "small"}, {"sweeps", {sweep}}};
  return run_study(Study::read(study, "test"), study, {});
}

nlohmann::json sweep() {
  return {{"shapes", {"ellipsoid:a=3,b=2,c=2.5"}},
          {"estimators", {"ii", "ii-covariance"}},
          {"evaluations", {"masks"}},
          {"radii", {{{"k", 2}}, {{"k", 3}}}},
          {"schedule", {{"values", {1, 0.5, 0.3}}}},
          {"shifts", 2}};
}

TEST(Surface, IsThatOfTheFinestStepAndTheFirstRadius) {
  const auto records = records_of(sweep());
  const auto chosen = records_of_surfaces(records);
  ASSERT_EQ(chosen.size(), 1u);
  ASSERT_EQ(chosen[0].size(), 2u);
  EXPECT_EQ(chosen[0][0]->estimator, "ii");
  EXPECT_EQ(chosen[0][1]->estimator, "ii-covariance");
  for (const Record* record : chosen[0]) {
    EXPECT_EQ(record->h, 0.3);
    EXPECT_EQ(record->shift, 0);
    EXPECT_EQ(record->k, 2);
  }
}

TEST(Surface, IsNotShownWhereItIsTooLargeRotatedNoisyOrFlat) {
  const auto with = [](auto change) {
    auto records = records_of(sweep());
    for (Record& record : records) change(record);
    return records_of_surfaces(records).size();
  };
  EXPECT_EQ(with([](Record&) {}), 1u);
  EXPECT_EQ(with([](Record& r) { r.surfels = most_surfels_shown + 1; }), 0u);
  EXPECT_EQ(with([](Record& r) { r.rotated = true; }), 0u);
  EXPECT_EQ(with([](Record& r) { r.noise = 0.1; }), 0u);
  EXPECT_EQ(with([](Record& r) { r.dimension = 2; }), 0u);
  auto records = records_of(sweep());
  for (Record& record : records)
    if (record.h < 0.5) record.surfels = most_surfels_shown + 1;
  EXPECT_EQ(records_of_surfaces(records)[0].front()->h, 0.5) << "the finest that can be shown";
}

TEST(Surface, HasTheErrorsOfTheRecords) {
  const auto records = records_of(sweep());
  const RecordedSurface surface = remake_surface(records_of_surfaces(records)[0]);
  EXPECT_EQ(std::int64_t(surface.surfels.size()), surface.records[0]->surfels);
  EXPECT_EQ(surface.truth.quantities, (std::vector<std::string>{"mean", "gaussian", "k1", "k2"}));
  for (std::size_t i = 0; i < surface.records.size(); ++i)
    for (const auto& [quantity, norms] : surface.records[i]->errors) {
      if (quantity == "normal") continue;
      double sup = 0;
      for (std::size_t s = 0; s < surface.surfels.size(); ++s)
        for (std::size_t q = 0; q < surface.truth.quantities.size(); ++q)
          if (surface.truth.quantities[q] == quantity)
            sup = std::max(sup, std::abs(surface.estimates[i][quantity][s] - surface.truth.columns[q][s]));
      EXPECT_DOUBLE_EQ(sup, norms.sup) << quantity;
    }
}

TEST(Surface, OfOtherRecordsIsRefused) {
  const auto failure = [](auto change) {
    auto records = records_of(sweep());
    for (Record& record : records)
      if (record.h == 0.3) change(record);
    const auto chosen = records_of_surfaces(records);
    return failure_of([&] { remake_surface(chosen[0]); });
  };
  EXPECT_EQ(failure([](Record&) {}), "no failure");
  EXPECT_NE(failure([](Record& r) { r.surfels += 2; }).find("surfels"), std::string::npos);
  EXPECT_NE(failure([](Record& r) { r.k = 2.5; }).find("the rms error of mean"), std::string::npos);
  EXPECT_NE(failure([](Record& r) { r.offset.pop_back(); }).find("2 numbers"), std::string::npos);
  EXPECT_NE(failure([](Record& r) { r.k = 1e9; }).find("memory"), std::string::npos);
}

TEST(SurfaceJson, ArraysAreTheNumbers) {
  const auto records = records_of(sweep());
  const RecordedSurface surface = remake_surface(records_of_surfaces(records)[0]);
  const nlohmann::ordered_json arrays = surface_arrays(surface);
  std::vector<std::uint16_t> cells;
  std::vector<std::int8_t> signs, directions;
  for (std::size_t i = 0; i < surface.surfels.size(); ++i) {
    const Surfel<3>& surfel = surface.surfels[i];
    signs.push_back(surfel.sign);
    for (int k = 0; k < 3; ++k) {
      const int origin = arrays["origin"][std::size_t(k)];
      EXPECT_EQ(origin % 2, 0);
      cells.push_back(std::uint16_t(surfel.cell().coordinates[k] - origin));
    }
    for (const char* name : {"dir1_x", "dir1_y", "dir1_z", "dir2_x", "dir2_y", "dir2_z"})
      directions.push_back(std::int8_t(std::lround(127 * surface.estimates[1][name][i])));
  }
  EXPECT_EQ(arrays["cells"], base64(cells));
  EXPECT_EQ(arrays["signs"], base64(signs));
  EXPECT_TRUE(arrays["directions"][0].is_null());
  EXPECT_EQ(arrays["directions"][1], base64(directions));
  const auto& k1 = surface.estimates[1]["k1"];
  EXPECT_EQ(arrays["estimates"][1]["k1"], base64(std::vector<float>(k1.begin(), k1.end())));
  EXPECT_FALSE(arrays["estimates"][0].contains("k1")) << "ii has the mean alone";

  const nlohmann::ordered_json description = surface_description(surface);
  EXPECT_EQ(description["surfels"], surface.surfels.size());
  EXPECT_EQ(description["estimators"][0]["quantities"], (std::vector<std::string>{"mean"}));
  EXPECT_EQ(description["estimators"][1]["directions"], true);
}

TEST(SurfaceJson, SurfelsWithoutATruthHaveNone) {
  auto with_apex = sweep();
  with_apex["shapes"] = {"diabolo"};
  with_apex["schedule"] = {{"values", {0.3}}};
  const auto records = records_of(with_apex);
  const RecordedSurface surface = remake_surface(records_of_surfaces(records)[0]);
  ASSERT_GT(surface.records[0]->singular, 0);
  std::vector<float> expected(surface.truth.columns[0].begin(), surface.truth.columns[0].end());
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (!surface.truth.known[i]) expected[i] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(surface_arrays(surface)["truth"]["mean"], base64(expected));
}

}  // namespace
}  // namespace gridstep
