#include "experiments/record.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/core/testing_files.hpp"

namespace gridstep {
namespace {

using nlohmann::ordered_json;

/// A different number in every field, so that no two can be mixed up unnoticed.
Record example() {
  Record r;
  r.shape = "ellipse:a=20,b=7,angle=0";
  r.estimator = "ii";
  r.evaluation = "masks";
  r.centre = "surfel";
  r.dimension = 3;
  r.h = 0.1;
  r.k = 5;
  r.alpha = 1.0 / 3.0;
  r.noise = 0.25;
  r.rotated = true;
  r.shift = 4;
  r.offset = {0.125, 2.0 / 3.0, 1e-17};
  r.digital_radius = 23.2;
  r.surfels = 5'000'000'000;
  r.singular = 6;
  r.far = 7;
  r.components = 8;
  r.worst_residual = 9e-16;
  r.errors = {{"mean", {10.5, 11.5, 12.5, 13}}, {"gaussian", {14.5, 15.5, 16.5, 17}}};
  r.work = {18, 19'000'000'000, 20, 21, {22}, 23};
  r.seconds_digitize = 23.5;
  r.seconds_truth = 24.5;
  r.seconds_init = 25.5;
  r.seconds_eval = 26.5;
  return r;
}

TEST(Record, ComesBackFromItsLine) {
  const std::string line = to_json(example()).dump();
  const Record r = record_from(ordered_json::parse(line));
  EXPECT_EQ(to_json(r).dump(), line);
  // Not only the JSON: a field that neither direction knows would be missing on both sides above.
  const Record e = example();
  EXPECT_EQ(r.shape, e.shape);
  EXPECT_EQ(r.estimator, e.estimator);
  EXPECT_EQ(r.evaluation, e.evaluation);
  EXPECT_EQ(r.centre, e.centre);
  EXPECT_EQ(r.dimension, e.dimension);
  EXPECT_EQ(r.h, e.h);
  EXPECT_EQ(r.k, e.k);
  EXPECT_EQ(r.alpha, e.alpha);
  EXPECT_EQ(r.noise, e.noise);
  EXPECT_EQ(r.rotated, e.rotated);
  EXPECT_EQ(r.shift, e.shift);
  EXPECT_EQ(r.offset, e.offset);
  EXPECT_EQ(r.digital_radius, e.digital_radius);
  EXPECT_EQ(r.surfels, e.surfels);
  EXPECT_EQ(r.singular, e.singular);
  EXPECT_EQ(r.far, e.far);
  EXPECT_EQ(r.components, e.components);
  EXPECT_EQ(r.worst_residual, e.worst_residual);
  ASSERT_EQ(r.errors.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(r.errors[i].first, e.errors[i].first) << "quantities keep their order";
    EXPECT_EQ(r.errors[i].second.sup, e.errors[i].second.sup);
    EXPECT_EQ(r.errors[i].second.rms, e.errors[i].second.rms);
    EXPECT_EQ(r.errors[i].second.mean, e.errors[i].second.mean);
    EXPECT_EQ(r.errors[i].second.count, e.errors[i].second.count);
  }
  EXPECT_EQ(r.work.evaluations, e.work.evaluations);
  EXPECT_EQ(r.work.cells_visited, e.work.cells_visited);
  EXPECT_EQ(r.work.restarts, e.work.restarts);
  EXPECT_EQ(r.work.kernel_size, e.work.kernel_size);
  EXPECT_EQ(r.work.mask_sizes, e.work.mask_sizes);
  EXPECT_EQ(r.work.fallbacks, e.work.fallbacks);
  EXPECT_EQ(r.seconds_digitize, e.seconds_digitize);
  EXPECT_EQ(r.seconds_truth, e.seconds_truth);
  EXPECT_EQ(r.seconds_init, e.seconds_init);
  EXPECT_EQ(r.seconds_eval, e.seconds_eval);
}

TEST(Record, SaysWhereThereIsNoRadius) {
  Record r = example();
  r.k = r.alpha = r.digital_radius = 0;
  r.evaluation = r.centre = "";
  const ordered_json json = to_json(r);
  for (const char* key : {"k", "alpha", "digital_radius", "evaluation", "centre"})
    EXPECT_TRUE(json.at(key).is_null()) << key;
  EXPECT_EQ(to_json(record_from(json)), json);
  EXPECT_FALSE(record_from(json).takes_radius());
}

TEST(Record, MayHaveNoErrors) {
  Record r = example();
  r.errors.clear();
  EXPECT_TRUE(record_from(to_json(r)).errors.empty());
}

TEST(Record, NeedsEveryField) {
  const ordered_json whole = to_json(example());
  std::vector<ordered_json::json_pointer> places;
  const ordered_json flat = whole.flatten();
  for (const auto& [path, value] : flat.items())
    if (!path.starts_with("/offset/") && !path.starts_with("/work/mask_sizes/")) places.emplace_back(path);
  places.emplace_back("/offset");
  places.emplace_back("/work/mask_sizes");
  places.emplace_back("/work");
  places.emplace_back("/seconds");
  places.emplace_back("/errors");
  ASSERT_GT(places.size(), 30u);
  for (const auto& place : places) {
    ordered_json without = whole, of_other_type = whole;
    without[place.parent_pointer()].erase(place.back());
    const std::string message = failure_of([&] { record_from(without); });
    EXPECT_TRUE(message.starts_with("not a record: ")) << place << ": " << message;
    EXPECT_NE(message.find("'" + place.back() + "'"), std::string::npos) << place << ": " << message;
    of_other_type[place] = {{"other", 1}};
    EXPECT_TRUE(failure_of([&] { record_from(of_other_type); }).starts_with("not a record: ")) << place;
  }
}

TEST(Record, IsAnObject) {
  for (const char* text : {"[]", "3", "null", "\"record\""})
    EXPECT_TRUE(failure_of([&] { record_from(ordered_json::parse(text)); }).starts_with("not a record: "));
}

}  // namespace
}  // namespace gridstep
