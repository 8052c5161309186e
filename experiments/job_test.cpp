#include "experiments/job.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gridstep {
namespace {

Study solid() {
  return Study::read(nlohmann::json::parse(R"({"name": "solid", "sweeps": [{
    "shapes": ["torus:major=6,minor=2"], "estimators": ["ii", "ii-covariance"], "evaluations": ["masks", "bricks"],
    "radii": [{"k": 1.5}], "schedule": {"values": [0.25]}, "shifts": 1}]})"),
                     "test.json");
}

std::string errors_of(const Record& record) {
  return to_json(record)["errors"].dump();
}

TEST(RunJob, GivesTheSameErrorsWhateverTheParts) {
  const Study study = solid();
  const Job job{&study.sweeps[0], 0, 0, 0, 0};
  const auto shape = make_shape<3>("torus:major=6,minor=2");
  const std::vector<Record> whole = run_job<3>(study, job, *shape);
  ASSERT_EQ(whole.size(), 4u);
  ASSERT_GT(whole[0].surfels, 3 * 999);
  for (const std::size_t most : {std::size_t{1000}, std::size_t{999}}) {
    const std::vector<Record> parts = run_job<3>(study, job, *shape, most);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_EQ(errors_of(parts[i]), errors_of(whole[i]));
      EXPECT_EQ(parts[i].surfels, whole[i].surfels);
      EXPECT_EQ(parts[i].singular, whole[i].singular);
      EXPECT_EQ(parts[i].worst_residual, whole[i].worst_residual);
      EXPECT_EQ(parts[i].work.kernel_size, whole[i].work.kernel_size);
      EXPECT_GE(parts[i].work.evaluations, whole[i].work.evaluations);
      EXPECT_LT(double(parts[i].work.evaluations), 1.5 * double(whole[i].work.evaluations));
    }
  }
}

TEST(RunJob, GivesWhatLooksAtTheSurfaceAllOfItWhateverTheParts) {
  const Study study = Study::read(nlohmann::json::parse(R"({"name": "surface", "sweeps": [{
    "shapes": ["torus:major=6,minor=2"], "estimators": ["icnc", "ccnc", "vcm"], "evaluations": ["masks", "bricks"],
    "radii": [{"k": 1.5}], "schedule": {"values": [0.25]}, "shifts": 1}]})"),
                                  "test.json");
  const Job job{&study.sweeps[0], 0, 0, 0, 0};
  const auto shape = make_shape<3>("torus:major=6,minor=2");
  const std::vector<Record> whole = run_job<3>(study, job, *shape), parts = run_job<3>(study, job, *shape, 1000);
  ASSERT_EQ(whole.size(), 5u) << "vcm has but one way to be evaluated";
  EXPECT_EQ(whole.back().evaluation, "");
  EXPECT_GT(whole.back().digital_radius, 1);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_FALSE(whole[i].errors.empty());
    EXPECT_EQ(errors_of(parts[i]), errors_of(whole[i])) << whole[i].estimator;
  }
}

TEST(RunJob, NamesTheStepThatIsTooCoarse) {
  const Study study = Study::read(nlohmann::json::parse(R"({"name": "coarse", "sweeps": [{
    "shapes": ["sphere:radius=0.01"], "estimators": ["ii"],
    "radii": [{"k": 3}], "schedule": {"values": [1]}, "shifts": 1}]})"),
                                  "test.json");
  try {
    run_job<3>(study, {&study.sweeps[0], 0, 0, 0, 0}, *make_shape<3>("sphere:radius=0.01"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("h = 1"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gridstep
