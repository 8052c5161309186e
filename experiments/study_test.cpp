#include "experiments/study.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

using nlohmann::json;

json valid() {
  return json::parse(
      R"({"name": "test", "sweeps": [{"shapes": ["disk"], "estimators": ["ii"], "radii": [{"k": 3}],
                         "schedule": {"from": 1, "to": 0.5, "steps": 3}}]})");
}

TEST(Study, FillsInDefaults) {
  const Study study = Study::read(valid(), "test.json");
  EXPECT_EQ(study.seed, 1u);
  EXPECT_FALSE(study.timing);
  const Sweep& sweep = study.sweeps.at(0);
  EXPECT_EQ(sweep.dimension(), 2);
  EXPECT_EQ(sweep.evaluations, std::vector{Evaluation::masks});
  EXPECT_EQ(sweep.noise, std::vector{0.0});
  EXPECT_EQ(sweep.shifts, 10);
  EXPECT_DOUBLE_EQ(sweep.radii.at(0).alpha, 1.0 / 3.0);
}

struct BadStudy {
  const char* name;
  const char* patch;  // RFC 7396, applied to the valid study's sweep, or to the study itself
  bool in_sweep;
  std::vector<std::string> named;  // what the message must hold
};
std::ostream& operator<<(std::ostream& out, const BadStudy& bad) {
  return out << bad.name;
}

class Refused : public testing::TestWithParam<BadStudy> {};

TEST_P(Refused, NamesTheSourceThePlaceTheKeyAndTheValue) {
  json study = valid();
  (GetParam().in_sweep ? study["sweeps"][0] : study).merge_patch(json::parse(GetParam().patch));
  try {
    Study::read(study, "test.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("test.json: "), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const std::string& part : GetParam().named)
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Study, Refused,
    testing::Values(BadStudy{"UnknownKey", R"({"foo": 1})", false, {"'foo'"}},
                    BadStudy{"UnknownKeyInSweep", R"({"shift": 3})", true, {"sweeps[0]", "'shift'"}},
                    BadStudy{"NoName", R"({"name": null})", false, {"name"}},
                    BadStudy{"NameWithSlash", R"({"name": "a/b"})", false, {"a/b"}},
                    BadStudy{"NoSweeps", R"({"sweeps": []})", false, {"sweeps"}},
                    BadStudy{"NoShapes", R"({"shapes": []})", true, {"shapes"}},
                    BadStudy{"UnknownShape", R"({"shapes": ["blob"]})", true, {"'blob'"}},
                    BadStudy{"BadParameter", R"({"shapes": ["disk:radius=-1"]})", true, {"radius", "-1"}},
                    BadStudy{"MixedDimensions", R"({"shapes": ["disk", "sphere"]})", true, {"sphere", "3D"}},
                    BadStudy{"UnknownEstimator", R"({"estimators": ["iii"]})", true, {"'iii'"}},
                    BadStudy{"EstimatorWithoutThatDimension",
                             R"({"estimators": ["ii-covariance"]})",
                             true,
                             {"ii-covariance", "2D"}},
                    BadStudy{"UnknownEvaluation", R"({"evaluations": ["fast"]})", true, {"'fast'"}},
                    BadStudy{"UnknownCentre", R"({"centre": "middle"})", true, {"'middle'"}},
                    BadStudy{"NegativeK", R"({"radii": [{"k": -3}]})", true, {"radii[0]", "k", "-3"}},
                    BadStudy{"Alpha", R"({"radii": [{"k": 3, "alpha": 1.5}]})", true, {"alpha", "1.5"}},
                    BadStudy{"Noise", R"({"noise": [0, 1]})", true, {"noise"}},
                    BadStudy{"NoShift", R"({"shifts": 0})", true, {"shifts", "0"}},
                    BadStudy{"ZeroStep", R"({"schedule": {"to": 0}})", true, {"schedule", "to", "0"}},
                    BadStudy{"KernelSmallerThanACell",
                             R"({"radii": [{"k": 0.5, "alpha": 0.5}]})",
                             true,
                             {"h = 1", "k = 0.5", "alpha = 0.5", "R/h = 0.5"}}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace gridstep
