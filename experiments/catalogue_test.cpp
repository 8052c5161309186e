#include "experiments/catalogue.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/core/json_reader.hpp"
#include "experiments/core/slope.hpp"
#include "experiments/core/testing_files.hpp"
#include "experiments/detail_study.hpp"
#include "experiments/study.hpp"

namespace gridstep {
namespace {

struct Sized {
  std::string name, size, text;
};

std::vector<Sized> all_sizes(bool of_detail) {
  std::vector<Sized> result;
  for (const StudyEntry& entry : study_catalogue()) {
    if (DetailStudy::is(nlohmann::json::parse(entry.quick)) != of_detail) continue;
    result.push_back({entry.name, "quick", entry.quick});
    result.push_back({entry.name, "full", entry.full});
  }
  return result;
}

void PrintTo(const Sized& study, std::ostream* out) {
  *out << study.name << " " << study.size;
}

class BuiltInStudy : public testing::TestWithParam<Sized> {};

TEST_P(BuiltInStudy, IsRead) {
  const nlohmann::json json = nlohmann::json::parse(GetParam().text);
  const Study study = Study::read(json, GetParam().name);
  EXPECT_EQ(study.name, GetParam().name) << "records must name the study under which they can be run again";
  EXPECT_FALSE(study.description.empty());
  for (const Sweep& sweep : study.sweeps) {
    for (const ShapeSpec& spec : sweep.shapes)
      std::visit([](const auto& shape) { EXPECT_GT(shape->size(), 0); }, make_shape(spec));
    for (const std::string& name : sweep.estimators) {
      const EstimatorEntry& entry = find_estimator(name);
      EXPECT_TRUE(sweep.dimension() == 2 ? entry.in_2d.has_value() : entry.in_3d.has_value());
    }
  }
}

TEST_P(BuiltInStudy, HasEnoughStepsForItsVerdicts) {
  const Study study = Study::read(nlohmann::json::parse(GetParam().text), GetParam().name);
  for (const Sweep& sweep : study.sweeps) EXPECT_GE(sweep.schedule.values().size(), fewest_levels);
}

TEST_P(BuiltInStudy, ReadsFromAFileAsBuiltIn) {
  // Duplicate keys are only refused by the reader of files.
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "study.json";
  std::ofstream(file) << GetParam().text;
  EXPECT_EQ(load_json(file), nlohmann::json::parse(GetParam().text));
}

class BuiltInDetailStudy : public testing::TestWithParam<Sized> {};

TEST_P(BuiltInDetailStudy, IsRead) {
  const DetailStudy study = DetailStudy::read(nlohmann::json::parse(GetParam().text), GetParam().name);
  EXPECT_EQ(study.name, GetParam().name);
  EXPECT_FALSE(study.description.empty());
  EXPECT_TRUE(study.shape.has_value()) << "a volume is the user's";
  EXPECT_GE(study.digital_radii.size(), 2u);
}

std::string name_of_size(const testing::TestParamInfo<Sized>& tested) {
  std::string name = tested.param.name + "_" + tested.param.size;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, BuiltInStudy, testing::ValuesIn(all_sizes(false)), name_of_size);
INSTANTIATE_TEST_SUITE_P(Catalogue, BuiltInDetailStudy, testing::ValuesIn(all_sizes(true)), name_of_size);

TEST(StudyCatalogue, HasUniqueNames) {
  std::set<std::string> names;
  for (const StudyEntry& entry : study_catalogue()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.summary.empty()) << entry.name;
  }
  EXPECT_FALSE(names.empty());
}

TEST(StudyCatalogue, NamesWhatItDoesNotKnow) {
  EXPECT_EQ(find_study("noise").name, "noise");
  const std::string message = failure_of([] { find_study("paper-4d"); });
  EXPECT_TRUE(message.starts_with("unknown study 'paper-4d' (and no such file); known: paper-2d, "))
      << message;
}

}  // namespace
}  // namespace gridstep
