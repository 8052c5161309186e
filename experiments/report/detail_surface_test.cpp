#include "experiments/report/detail_surface.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/core/testing_files.hpp"
#include "experiments/distribution.hpp"
#include "experiments/report/base64.hpp"
#include "experiments/report/surface_json.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/files/surface_file.hpp"

namespace gridstep {
namespace {

constexpr GridStep kStep{0.3};

std::vector<Surfel<3>> cuboid() {
  DigitalSet<3> set({LatticePoint<3>{-2, -2, -2}, LatticePoint<3>{4, 4, 4}});
  for_each_point(LatticeBox<3>{{-1, -1, -1}, {2, 1, 0}}, [&](const LatticePoint<3>& z) { set.set(z, true); });
  return boundary(set);
}

/// Any, but another one for each quantity, level and surfel.
double value_at(std::size_t quantity, std::size_t level, std::size_t surfel) {
  return 1.0 / double(3 + quantity + 7 * level + 31 * surfel);
}

/// What a study of detail leaves in its folder.
class DetailFolder : public ::testing::Test {
 protected:
  const std::vector<std::string> titles{"mean", "normal_x", "k1", "component"};
  const std::vector<Surfel<3>> surfels = cuboid();
  TemporaryFolder folder;
  ResultsFolder results{folder.path(), {}, {}};

  DetailFolder() {
    auto& detail = results.summary["detail"] = {
        {"input", "al.vol"}, {"h", kStep.value}, {"estimator", "ii-covariance"}, {"surfels", surfels.size()}};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string name = std::string("radius-") + char('2' + i) + ".ply";
      nlohmann::json level{{"digital_radius", 2.0 + double(i)}, {"surfaces", {"radius.vtp", name}}};
      SurfelTable table{surfels.size(), {}, {}};
      for (std::size_t q = 0; q < titles.size(); ++q)
        table.values.push_back(
            {titles[q], SurfelColumn::Type::real, [q, i](std::size_t s) { return value_at(q, i, s); }});
      for (const std::size_t q : {0, 2})
        level["quantities"][titles[q]] = to_json(distribution_of(column(q, i)));
      std::ofstream file(folder.path() / name);
      write_ply(table, quad_mesh(surfels, kStep), [&](std::string_view text) { file << text; });
      detail["levels"].push_back(level);
    }
  }

  std::vector<double> column(std::size_t quantity, std::size_t level) const {
    std::vector<double> values;
    for (std::size_t s = 0; s < surfels.size(); ++s) values.push_back(value_at(quantity, level, s));
    return values;
  }
};

TEST_F(DetailFolder, HasWhatWasWritten) {
  const DetailSurface surface = read_detail_surface(results);
  EXPECT_EQ(surface.surfels, surfels);
  EXPECT_EQ(surface.input, "al.vol");
  EXPECT_EQ(surface.digital_radii, (std::vector<double>{2, 3}));
  EXPECT_TRUE(surface.truth.quantities.empty());
  ASSERT_EQ(surface.estimates.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(surface.quantities[i], (std::vector<std::string>{"mean", "k1"}))
        << "as summary.json, in the file's order";
    for (std::size_t q = 0; q < titles.size(); ++q) EXPECT_EQ(surface.estimates[i][titles[q]], column(q, i));
  }
}

TEST_F(DetailFolder, BecomesArraysWithoutATruth) {
  const DetailSurface surface = read_detail_surface(results);
  const nlohmann::ordered_json arrays = surface_arrays(surface), description = surface_description(surface);
  EXPECT_TRUE(arrays["truth"].empty());
  ASSERT_EQ(arrays["estimates"].size(), 2u);
  const std::vector<double> k1 = column(2, 1);
  EXPECT_EQ(arrays["estimates"][1]["k1"], base64(std::vector<float>(k1.begin(), k1.end())));
  EXPECT_FALSE(arrays["estimates"][1].contains("normal_x"));
  EXPECT_TRUE(arrays["directions"][0].is_null());
  EXPECT_EQ(description["side_by_side"], true);
  EXPECT_EQ(description["surfels"], surfels.size());
  EXPECT_EQ(description["estimators"][1]["digital_radius"], 3);
  EXPECT_EQ(description["estimators"][1]["quantities"], (std::vector<std::string>{"mean", "k1"}));
}

TEST_F(DetailFolder, IsRefusedWhereItIsTooLargeOrNotThatOfItsSummary) {
  const auto failure = [&](auto change) {
    ResultsFolder changed = results;
    change(changed.summary["detail"]);
    return failure_of([&] { read_detail_surface(changed); });
  };
  EXPECT_EQ(failure([](auto&) {}), "no failure");
  const std::string too_large = failure([](auto& detail) { detail["surfels"] = most_surfels_shown + 1; });
  EXPECT_EQ(too_large, "al.vol at h = 0.3: 200001 surfels, more than the 200000 that a page shows");
  const std::string file = (folder.path() / "radius-3.ply").string() + ": ";
  const struct {
    std::string message, named;
  } cases[] = {
      {failure([](auto& detail) { detail["surfels"] = 3; }), "3 surfels"},
      {failure([](auto& detail) { detail["h"] = 0.7; }), "no surfel at h = 0.7"},
      {failure([](auto& detail) { detail["levels"][1]["surfaces"] = {"none.ply"}; }), "none.ply: not found"},
      {failure([](auto& detail) { detail["levels"][1]["surfaces"] = {"radius.vtp"}; }),
       "no PLY file of R/h = 3"},
      {failure([](auto& detail) { detail["levels"][1]["surfaces"] = {"radius-2.ply"}; }),
       "the values of mean"},
      {failure([](auto& detail) { detail["levels"][1]["quantities"]["k1"]["quantiles"][4] = 9; }),
       file + "the values of k1"},
      {failure([](auto& detail) { detail["levels"][1]["quantities"]["kappa"] = 0; }),
       file + "values of 2 quantities"},
  };
  for (const auto& [message, named] : cases) EXPECT_NE(message.find(named), std::string::npos) << message;
}

TEST_F(DetailFolder, IsRefusedWhereARadiusHasAnotherSurface) {
  auto turned = surfels;
  std::swap(turned[0], turned[1]);
  SurfelTable table{turned.size(), {}, {}};
  for (std::size_t q : {0, 2})
    table.values.push_back(
        {titles[q], SurfelColumn::Type::real, [q](std::size_t s) { return value_at(q, 1, s); }});
  std::ofstream file(folder.path() / "radius-3.ply");
  write_ply(table, quad_mesh(turned, kStep), [&](std::string_view text) { file << text; });
  file.close();
  EXPECT_NE(failure_of([&] { read_detail_surface(results); }).find("another surface"), std::string::npos);
}

}  // namespace
}  // namespace gridstep
