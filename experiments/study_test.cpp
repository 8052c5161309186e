#include "experiments/study.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/core/json_reader.hpp"
#include "experiments/core/testing_files.hpp"

namespace gridstep {
namespace {

using nlohmann::json;

json valid() {
  return json::parse(R"({
    "name": "mine", "description": "a test", "seed": 7, "timing": true,
    "sweeps": [{
      "shapes": ["disk:radius=5", {"name": "ellipse", "a": 4, "b": 3}],
      "estimators": ["ii"], "evaluations": ["full", "masks"],
      "radii": [{"k": 2}, {"k": 1.5, "alpha": 0.25}],
      "noise": [0, 0.25], "centre": "surfel", "rotate": true,
      "schedule": {"values": [1, 0.5]}, "shifts": 3
    }]})");
}

json minimal() {
  return json::parse(R"({"name": "least", "sweeps": [{"shapes": ["disk"], "estimators": ["ii"],
    "radii": [{"k": 2}], "schedule": {"from": 1, "to": 0.5, "steps": 3}}]})");
}

/// The message about a valid study after one change: a merge patch, in which null removes a key.
std::string failure_with(const std::string& patch) {
  json study = valid();
  study.merge_patch(json::parse(patch));
  return failure_of([&] { Study::read(study, "mine.json"); });
}

std::string failure_with_sweep(const std::string& patch) {
  json study = valid();
  study["sweeps"][0].merge_patch(json::parse(patch));
  return failure_of([&] { Study::read(study, "mine.json"); });
}

TEST(Study, IsReadFromJson) {
  const Study study = Study::read(valid(), "mine.json");
  EXPECT_EQ(study.name, "mine");
  EXPECT_EQ(study.description, "a test");
  EXPECT_EQ(study.seed, 7u);
  EXPECT_TRUE(study.timing);
  ASSERT_EQ(study.sweeps.size(), 1u);
  const Sweep& sweep = study.sweeps[0];
  ASSERT_EQ(sweep.shapes.size(), 2u);
  EXPECT_EQ(sweep.shapes[0].canonical(), "disk:radius=5");
  EXPECT_EQ(sweep.shapes[1].canonical(), "ellipse:a=4,b=3,angle=0");
  EXPECT_EQ(sweep.dimension(), 2);
  EXPECT_EQ(sweep.estimators, std::vector<std::string>{"ii"});
  EXPECT_EQ(sweep.evaluations, (std::vector<Evaluation>{Evaluation::full, Evaluation::masks}));
  ASSERT_EQ(sweep.radii.size(), 2u);
  EXPECT_EQ(sweep.radii[0].k, 2);
  EXPECT_EQ(sweep.radii[0].alpha, 1.0 / 3.0);
  EXPECT_EQ(sweep.radii[1].k, 1.5);
  EXPECT_EQ(sweep.radii[1].alpha, 0.25);
  EXPECT_EQ(sweep.noise, (std::vector<double>{0, 0.25}));
  EXPECT_EQ(sweep.centre, KernelCentre::surfel);
  EXPECT_TRUE(sweep.rotate);
  EXPECT_EQ(sweep.schedule.values(), (std::vector<double>{1, 0.5}));
  EXPECT_EQ(sweep.shifts, 3);
}

TEST(Study, HasDocumentedDefaults) {
  const Study study = Study::read(minimal(), "least.json");
  EXPECT_EQ(study.description, "");
  EXPECT_EQ(study.seed, 1u);
  EXPECT_FALSE(study.timing);
  const Sweep& sweep = study.sweeps.at(0);
  EXPECT_EQ(sweep.evaluations, std::vector<Evaluation>{Evaluation::bricks});
  EXPECT_EQ(sweep.noise, std::vector<double>{0});
  EXPECT_EQ(sweep.centre, KernelCentre::spels);
  EXPECT_FALSE(sweep.rotate);
  EXPECT_EQ(sweep.shifts, 10);
}

TEST(Study, TakesEverySeed) {
  json study = minimal();
  study["seed"] = std::uint64_t(-1);
  EXPECT_EQ(Study::read(study, "").seed, std::uint64_t(-1));
  study["seed"] = 0;
  EXPECT_EQ(Study::read(study, "").seed, 0u);
}

struct Case {
  const char *patch, *message;
};

TEST(Study, NamesTheKeyAndTheValueThatAreWrong) {
  const Case cases[] = {
      {R"({"name": null})", "key 'name' is missing"},
      {R"({"name": 3})", "name = 3 must be a text"},
      {R"({"name": ""})", "name = \"\" must be a name without slashes"},
      {R"({"name": "../up"})", "name = \"../up\" must be a name without slashes"},
      {R"({"description": ["a"]})", "description = [\"a\"] must be a text"},
      {R"({"seed": -1})", "seed = -1 must be an integer from 0 to 2^64 - 1"},
      {R"({"seed": 1.5})", "seed = 1.5 must be an integer from 0 to 2^64 - 1"},
      {R"({"seed": "1"})", "seed = \"1\" must be an integer from 0 to 2^64 - 1"},
      {R"({"timing": 1})", "timing = 1 must be true or false"},
      {R"({"tables": ["cots"]})",
       "tables = [\"cots\"] must be a list of convergence, cost, work-precision, equal-error, best-radius, noise, isotropy"},
      {R"({"sweeps": null})", "key 'sweeps' is missing"},
      {R"({"sweeps": []})", "sweeps = [] must be a list with at least one entry"},
      {R"({"sweeps": {}})", "sweeps = {} must be a list of objects"},
      {R"({"sweeps": ["disk"]})", "sweeps[0]: \"disk\" must be an object"},
      {R"({"sweep": []})", "unknown key 'sweep' (known: description, name, seed, sweeps, tables, timing)"}};
  for (const auto& [patch, message] : cases)
    EXPECT_EQ(failure_with(patch), std::string("mine.json: ") + message) << patch;
  EXPECT_EQ(failure_of([] { Study::read(json::array(), "mine.json"); }), "mine.json: [] must be an object");
}

TEST(Study, NamesThePlaceInASweepToo) {
  const Case cases[] = {
      {R"({"shapes": null})", "key 'shapes' is missing"},
      {R"({"shapes": []})", "shapes = [] must be a list with at least one entry"},
      {R"({"shapes": "disk"})", "shapes = \"disk\" must be a list with at least one entry"},
      {R"({"shapes": [3]})", "shape: expected an object with a \"name\", not 3"},
      {R"({"shapes": ["disk:radius=-1"]})", "shape 'disk': radius = -1 must be a finite number > 0"},
      {R"({"shapes": ["disk:radius=x"]})", "shape 'disk:radius=x': radius = 'x' is not a number"},
      {R"({"shapes": [{"name": "disk", "radius": true}]})",
       "shape 'disk': radius = true is neither a number nor a text"},
      {R"({"shapes": ["disk:diameter=1"]})",
       "shape 'disk' has no parameter 'diameter'; it has: radius, cx, cy"},
      {R"({"shapes": ["disk", "sphere"]})", "shape 'sphere' is 3D, the ones before are 2D"},
      {R"({"shapes": ["sphere", "cube", "disk"]})", "shape 'disk' is 2D, the ones before are 3D"},
      {R"({"estimators": null})", "key 'estimators' is missing"},
      {R"({"estimators": []})", "estimators = [] must be a list with at least one entry"},
      {R"({"estimators": "ii"})", "estimators = \"ii\" must be a list of texts"},
      {R"({"estimators": [1]})", "estimators[0] = 1 must be a text"},
      {R"({"estimators": ["ii-covariance"]})", "estimator 'ii-covariance' has no 2D form"},
      {R"({"evaluations": []})", "evaluations = [] must be a list with at least one entry"},
      {R"({"evaluations": "full"})", "evaluations = \"full\" must be a list of texts"},
      {R"({"centre": "pointel"})", "unknown kernel centre 'pointel'; known: spels, surfel"},
      {R"({"centre": 1})", "centre = 1 must be a text"},
      {R"({"estimators": ["ii-ho1"], "evaluations": ["masks"]})",
       "estimator 'ii-ho1' has no evaluation 'masks'; it has: full, bricks"},
      {R"({"radii": []})", "radii = [] must be a list with at least one entry"},
      {R"({"radii": {"k": 2}})", "radii = {\"k\":2} must be a list of objects"},
      {R"({"noise": []})", "noise = [] must be a list with at least one entry"},
      {R"({"noise": 0.1})", "noise = 0.1 must be a list of numbers"},
      {R"({"noise": [0, "x"]})", "noise[1] = \"x\" must be a number"},
      {R"({"noise": [0, 1]})", "noise = [0,1] must be a list of numbers in [0, 1)"},
      {R"({"noise": [-0.5]})", "noise = [-0.5] must be a list of numbers in [0, 1)"},
      {R"({"shifts": 0})", "shifts = 0 must be from 1 to 10000"},
      {R"({"shifts": 2000000000})", "shifts = 2000000000 must be from 1 to 10000"},
      {R"({"shifts": 2.5})", "shifts = 2.5 must be an integer"},
      {R"({"rotate": "yes"})", "rotate = \"yes\" must be true or false"},
      {R"({"shift": 2})",
       "unknown key 'shift' (known: centre, estimators, evaluations, noise, radii, rotate, schedule, shapes, "
       "shifts)"}};
  for (const auto& [patch, message] : cases)
    EXPECT_EQ(failure_with_sweep(patch), std::string("mine.json: sweeps[0]: ") + message) << patch;
}

json without_radius() {
  return json::parse(R"({"name": "contours", "sweeps": [{"shapes": ["disk"], "estimators": ["bc", "mst"],
    "schedule": {"from": 1, "to": 0.5, "steps": 3}}]})");
}

TEST(Study, NeedsNoRadiusWhereNoEstimatorTakesOne) {
  const Study study = Study::read(without_radius(), "mine.json");
  EXPECT_TRUE(study.sweeps[0].radii.empty());
  const auto methods = study.sweeps[0].methods();
  ASSERT_EQ(methods.size(), 2u);
  EXPECT_EQ(methods[1].estimator, "mst");
  EXPECT_FALSE(methods[1].radius.has_value() || methods[1].evaluation.has_value());
  for (const char* key : {"radii", "evaluations", "centre"}) {
    json given = without_radius();
    given["sweeps"][0][key] = valid()["sweeps"][0][key];
    EXPECT_NE(failure_of([&] {
                Study::read(given, "mine.json");
              }).find("must be left out: no estimator here takes a radius"),
              std::string::npos)
        << key;
  }
}

TEST(Study, TakesTheUsualRadiusOfEachEstimatorWhereNoneIsGiven) {
  json usual = valid();
  usual["sweeps"][0].erase("radii");
  usual["sweeps"][0]["estimators"] = {"ii", "ii-ho1", "mdca"};
  usual["sweeps"][0]["evaluations"] = {"bricks"};
  const auto methods = Study::read(usual, "mine.json").sweeps[0].methods();
  ASSERT_EQ(methods.size(), 3u);
  EXPECT_EQ(methods[0].radius, (RadiusRule{5}));
  EXPECT_EQ(methods[1].radius, (RadiusRule{8}));
  EXPECT_FALSE(methods[2].radius.has_value());
}

TEST(Study, TakesMethodsOncePerRadiusAndEvaluationOrOnce) {
  json mixed = valid();
  mixed["sweeps"][0]["estimators"] = {"bc", "ii", "mst"};
  const Study study = Study::read(mixed, "mine.json");
  std::string order;
  for (const Method& method : study.sweeps[0].methods())
    order += method.estimator + (method.radius ? std::to_string(method.radius->k).substr(0, 3) : "") +
             (method.evaluation ? to_string(*method.evaluation) : "") + " ";
  EXPECT_EQ(order, "bc ii2.0full ii2.0masks mst ii1.5full ii1.5masks ");
}

TEST(Study, PrintsTheTablesThatItAsksFor) {
  EXPECT_EQ(Study::read(minimal(), "mine.json").tables, std::vector<std::string>{"convergence"});
  EXPECT_EQ(Study::read(valid(), "mine.json").tables, std::vector<std::string>{"cost"}) << "of timings";
  json both = minimal();
  both["tables"] = {"equal-error", "convergence"};
  EXPECT_EQ(Study::read(both, "mine.json").tables, (std::vector<std::string>{"equal-error", "convergence"}));
}

TEST(Study, ListsTheNamesThatItKnows) {
  const Case cases[] = {{R"({"shapes": ["dsik"]})", "unknown shape 'dsik'; known: "},
                        {R"({"shapes": [{"name": "dsik"}]})", "unknown shape 'dsik'; known: "},
                        {R"({"estimators": ["iii"]})", "unknown estimator 'iii'; known: ii"},
                        {R"({"evaluations": ["fast"]})", "unknown evaluation 'fast'; known: "}};
  for (const auto& [patch, message] : cases)
    EXPECT_TRUE(failure_with_sweep(patch).starts_with(std::string("mine.json: sweeps[0]: ") + message))
        << failure_with_sweep(patch);
}

TEST(Study, NamesThePlaceInARadius) {
  const Case cases[] = {{R"({"k": 0})", "k = 0 must be positive"},
                        {R"({"k": -2})", "k = -2 must be positive"},
                        {R"({"k": "2"})", "k = \"2\" must be a number"},
                        {R"({})", "key 'k' is missing"},
                        {R"({"k": 2, "alpha": 1})", "alpha = 1 must be in [0, 1)"},
                        {R"({"k": 2, "alpha": -0.1})", "alpha = -0.1 must be in [0, 1)"},
                        {R"({"k": 2, "alpha": null})", "alpha = null must be a number"},
                        {R"({"k": 2, "aplha": 0.5})", "unknown key 'aplha' (known: alpha, k)"}};
  for (const auto& [radius, message] : cases) {
    json study = valid();
    study["sweeps"][0]["radii"][1] = json::parse(radius);
    EXPECT_EQ(failure_of([&] { Study::read(study, "mine.json"); }),
              std::string("mine.json: sweeps[0].radii[1]: ") + message);
  }
}

TEST(Study, NamesThePlaceInASchedule) {
  const Case cases[] = {
      {R"({"from": 1, "to": 2, "steps": 3})",
       "sweeps[0].schedule: to = 2 must be less than from = 1: steps go from coarse to fine"},
      {R"({"from": 1, "to": 0.5})", "sweeps[0].schedule: key 'steps' is missing"},
      {R"({"values": [0.5, 1]})", "sweeps[0].schedule: values[1] = 1 must be less than values[0] = 0.5"},
      {R"({"papers": {"first": 3, "last": 2}})",
       "sweeps[0].schedule.papers: last = 2 must be greater than first = 3"},
      {R"([1, 0.5])", "sweeps[0].schedule: [1,0.5] must be an object"}};
  for (const auto& [schedule, message] : cases) {
    json study = valid();
    study["sweeps"][0]["schedule"] = json::parse(schedule);
    EXPECT_EQ(failure_of([&] { Study::read(study, "mine.json"); }), std::string("mine.json: ") + message);
  }
  json study = valid();
  study["sweeps"][0].erase("schedule");
  EXPECT_EQ(failure_of([&] { Study::read(study, "mine.json"); }),
            "mine.json: sweeps[0]: key 'schedule' is missing");
}

TEST(Study, RefusesARadiusBelowOneCell) {
  // R/h = 1.5 h^(-3/4) falls below 1 for coarse steps.
  json study = valid();
  study["sweeps"][0]["schedule"] = {{"values", {4, 1}}};
  EXPECT_EQ(failure_of([&] { Study::read(study, "mine.json"); }),
            "mine.json: sweeps[0]: h = 4 with k = 2, alpha = 0.333333: R/h = 0.793701 must be at least 1");
  study["sweeps"][0]["radii"].erase(0);
  EXPECT_EQ(failure_of([&] { Study::read(study, "mine.json"); }),
            "mine.json: sweeps[0]: h = 4 with k = 1.5, alpha = 0.25: R/h = 0.53033 must be at least 1");
  study["sweeps"][0]["radii"][0] = {{"k", 1}, {"alpha", 0.5}};
  study["sweeps"][0]["schedule"] = {{"values", {1, 0.5}}};
  EXPECT_NO_THROW(Study::read(study, "mine.json")) << "one cell is enough";
}

TEST(Study, NamesTheSecondSweep) {
  json study = valid();
  study["sweeps"].push_back(study["sweeps"][0]);
  study["sweeps"][1]["shifts"] = -1;
  EXPECT_EQ(failure_of([&] { Study::read(study, "mine.json"); }),
            "mine.json: sweeps[1]: shifts = -1 must be from 1 to 10000");
}

TEST(Study, RefusesAKeyThatAFileGivesTwice) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "twice.json";
  std::ofstream(file) << R"({"name": "a", "sweeps": [{"shifts": 1, "shapes": [], "shifts": 2}]})";
  EXPECT_EQ(failure_of([&] { load_json(file); }),
            file.string() + ": key 'shifts' is given twice in one object");
}

}  // namespace
}  // namespace gridstep
