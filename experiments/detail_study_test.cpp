#include "experiments/detail_study.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/core/testing_files.hpp"

namespace gridstep {
namespace {

using nlohmann::json;

json study_of(const json& detail) {
  return {{"name", "mine"}, {"detail", detail}};
}

const json kVolume{{"volume", "al.vol"}, {"digital_radii", {14, 7.5}}};
const json kShape{{"shape", "sphere:radius=5"}, {"h", 0.5}, {"digital_radii", {3}}};

json changed(json detail, const char* key, const json& value) {
  value.is_null() ? void(detail.erase(key)) : void(detail[key] = value);
  return detail;
}

TEST(DetailStudy, ReadsAVolume) {
  EXPECT_TRUE(DetailStudy::is(study_of(kVolume)));
  const DetailStudy study = DetailStudy::read(study_of(kVolume), "mine.json");
  EXPECT_EQ(study.volume, "al.vol");
  EXPECT_FALSE(study.shape.has_value());
  EXPECT_EQ(study.h, 0) << "the spacing in the file";
  EXPECT_FALSE(study.threshold.has_value());
  EXPECT_EQ(study.estimator, "ii-covariance");
  EXPECT_EQ(study.digital_radii, (std::vector<double>{14, 7.5}));
  const auto with_threshold = DetailStudy::read(study_of(changed(kVolume, "threshold", {1, 9})), "mine.json");
  EXPECT_EQ(with_threshold.threshold, std::make_pair(1.0, 9.0));
}

TEST(DetailStudy, ReadsAShape) {
  const DetailStudy study = DetailStudy::read(study_of(kShape), "mine.json");
  ASSERT_TRUE(study.shape.has_value());
  EXPECT_EQ(study.shape->name, "sphere");
  EXPECT_EQ(study.h, 0.5);
}

TEST(DetailStudy, NamesWhatIsWrong) {
  EXPECT_FALSE(DetailStudy::is({{"name", "mine"}, {"sweeps", json::array()}}));
  EXPECT_FALSE(DetailStudy::is(json::array()));
  const struct {
    json detail;
    std::vector<std::string> named;
  } cases[] = {
      {changed(kVolume, "shape", "sphere"), {"one of 'shape' and 'volume'"}},
      {changed(kVolume, "volume", nullptr), {"one of 'shape' and 'volume'"}},
      {changed(kVolume, "volume", 3), {"volume = 3"}},
      {changed(kVolume, "h", 0), {"h = 0", "positive"}},
      {changed(kVolume, "h", -1), {"h = -1"}},
      {changed(kVolume, "threshold", {9, 1}), {"threshold = [9,1]"}},
      {changed(kVolume, "threshold", {9}), {"threshold = [9]"}},
      {changed(kVolume, "digital_radii", json::array()), {"digital_radii = []"}},
      {changed(kVolume, "digital_radii", {7, 7}), {"digital_radii = [7,7]", "different"}},
      {changed(kVolume, "digital_radii", {0.5}), {"digital_radii = [0.5]", "at least 1"}},
      {changed(kVolume, "digital_radii", nullptr), {"digital_radii"}},
      {changed(kVolume, "estimator", "mdca"), {"'mdca'", "3D"}},
      {changed(kVolume, "estimator", "iii"), {"'iii'"}},
      {changed(kVolume, "radii", {3}), {"unknown key 'radii'"}},
      {changed(kShape, "shape", "spere"), {"'spere'"}},
      {changed(kShape, "shape", "disk"), {"'disk' is not 3D"}},
      {changed(kShape, "h", nullptr), {"'h'"}},
      {changed(kShape, "threshold", {1, 2}), {"unknown key 'threshold'"}},
      {"sphere", {"detail", "object"}},
  };
  for (const auto& [detail, named] : cases) {
    const std::string message = failure_of([&] { DetailStudy::read(study_of(detail), "mine.json"); });
    EXPECT_TRUE(message.starts_with("mine.json: ")) << message;
    for (const std::string& text : named)
      EXPECT_NE(message.find(text), std::string::npos) << text << ": " << message;
  }
}

}  // namespace
}  // namespace gridstep
