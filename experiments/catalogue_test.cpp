#include "experiments/catalogue.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "experiments/study.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

TEST(StudyCatalogue, EveryStudyParsesInBothSizesUnderItsOwnName) {
  std::set<std::string> names;
  for (const StudyEntry& entry : study_catalogue()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " is listed twice";
    EXPECT_FALSE(entry.summary.empty());
    for (const std::string& text : {entry.quick, entry.full})
      EXPECT_EQ(Study::read(nlohmann::json::parse(text), entry.name).name, entry.name);
  }
}

TEST(StudyCatalogue, NamesAnUnknownStudyAndTheKnownOnes) {
  try {
    find_study("paper-4d");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'paper-4d'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("paper-2d"), std::string::npos);
  }
}

}  // namespace
}  // namespace gridstep
