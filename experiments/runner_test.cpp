#include "experiments/runner.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/core/testing_files.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const char* const kStudy = R"({"name": "test", "sweeps": [
  {"shapes": ["disk", "square"], "estimators": ["ii"], "evaluations": ["masks", "full"], "radii": [{"k": 3}, {"k": 4}],
   "schedule": {"values": [0.5, 0.25]}, "shifts": 2},
  {"shapes": ["cube"], "estimators": ["ii", "ii-covariance"], "radii": [{"k": 3}], "noise": [0, 0.2],
   "schedule": {"values": [1]}, "shifts": 1, "rotate": true}]})";

std::vector<Record> run(const json& study, const RunOptions& options = {}) {
  return run_study(Study::read(study, "test"), study, options);
}

/// The records as text, without timings.
std::vector<std::string> numbers(const std::vector<Record>& records) {
  std::vector<std::string> result;
  for (const Record& record : records) {
    nlohmann::ordered_json line = to_json(record);
    line.erase("seconds");
    result.push_back(line.dump());
  }
  return result;
}

TEST(Runner, RecordsEveryCombinationInOrder) {
  const auto records = run(json::parse(kStudy));
  ASSERT_EQ(records.size(), 2u * 2 * 2 * 2 * 2 + 2 * 2);
  EXPECT_EQ(records[0].evaluation, "masks");
  EXPECT_EQ(records[1].evaluation, "full");
  EXPECT_EQ(records[0].k, 3);
  EXPECT_EQ(records[2].k, 4);
  EXPECT_EQ(records[4].shift, 1);
  EXPECT_EQ(records[8].h, 0.25);
  EXPECT_EQ(records[16].shape, "square:side=10,angle=0");
  EXPECT_EQ(records[32].estimator, "ii");
  EXPECT_EQ(records[33].estimator, "ii-covariance");
  EXPECT_EQ(records[34].noise, 0.2);
  EXPECT_GT(records[34].components, 0);
  for (const Record& record : records) {
    EXPECT_LE(record.worst_residual, 1e-12);
    EXPECT_EQ(record.errors.at(0).second.count + std::size_t(record.singular + record.far),
              std::size_t(record.surfels));
  }
  EXPECT_GT(records[32].singular, 0);  // edges of the cube
}

TEST(Runner, EvaluationsDifferInCostAlone) {
  const auto records = run(json::parse(kStudy));
  for (std::size_t i = 0; i < 32; i += 2) {
    EXPECT_EQ(records[i].errors.at(0).second.sup, records[i + 1].errors.at(0).second.sup);
    EXPECT_LT(records[i].work.cells_visited, records[i + 1].work.cells_visited);
  }
}

TEST(Runner, NumbersDoNotDependOnThreads) {
  const json study = json::parse(kStudy);
  const auto many = numbers(run(study));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(numbers(run(study)), many);
}

TEST(Runner, TheSeedDecidesTheShifts) {
  json study = json::parse(kStudy);
  const auto first = run(study), again = run(study);
  EXPECT_EQ(first[0].offset, again[0].offset);
  study["seed"] = 2u;
  EXPECT_NE(run(study)[0].offset, first[0].offset);
}

TEST(Runner, ResumesFromAnyPrefixOfTheJournal) {
  const json study = json::parse(kStudy);
  const TemporaryFolder folder;
  const fs::path journal = folder.path() / "journal.jsonl";
  const auto whole = numbers(run(study, {journal}));
  const std::string text = content_of(journal);
  std::size_t lines = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end + 1), ++lines) {
    // A kill in the middle of the next line as well.
    std::ofstream(journal) << text.substr(0, std::min(text.size(), end + 1 + 20));
    EXPECT_EQ(numbers(run(study, {journal, true})), whole);
  }
  EXPECT_EQ(lines, 1u + 8 + 2);
}

TEST(Runner, GoesOnWithAJournalOnlyWhenAskedAndOnlyOfTheSameStudy) {
  json study = json::parse(kStudy);
  const TemporaryFolder folder;
  const fs::path journal = folder.path() / "journal.jsonl";
  run(study, {journal});
  const std::string before = content_of(journal);
  EXPECT_THROW(run(study, {journal}), InputError);
  study["seed"] = 5u;
  EXPECT_THROW(run(study, {journal, true}), InputError);
  EXPECT_EQ(content_of(journal), before);
}

TEST(Runner, RefusesWhatDoesNotFitInMemoryBeforeItStarts) {
  json study = json::parse(kStudy);
  study["sweeps"][1]["schedule"] = {{"values", {1, 1e-5}}};
  const TemporaryFolder folder;
  const fs::path journal = folder.path() / "journal.jsonl";
  try {
    run(study, {journal});
    FAIL() << "started";
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const char* part : {"cube", "1e-05", "GiB"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_FALSE(fs::exists(journal));
}

TEST(Runner, NamesTheShapeThatIsTooSmallForTheGrid) {
  json study = json::parse(kStudy);
  study["sweeps"][0]["shapes"] = {"disk:radius=0.01,cx=0.3"};
  study["sweeps"][0]["shifts"] = 1;
  try {
    run(study);
    FAIL() << "digitized";
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const char* part : {"disk:radius=0.01", "h = 0.5"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(Record, SurvivesJson) {
  for (const Record& record : run(json::parse(kStudy)))
    EXPECT_EQ(to_json(record_from(to_json(record))).dump(), to_json(record).dump());
  EXPECT_THROW(record_from(nlohmann::ordered_json::object()), InputError);
}

}  // namespace
}  // namespace gridstep
