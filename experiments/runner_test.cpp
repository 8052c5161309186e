#include "experiments/runner.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiments/core/testing_files.hpp"

namespace gridstep {
namespace {

using nlohmann::json;

json flat() {
  return json::parse(R"({"name": "flat", "sweeps": [{
    "shapes": ["disk:radius=5", "ellipse:a=6,b=3"], "estimators": ["ii"], "evaluations": ["full", "masks"],
    "radii": [{"k": 2}, {"k": 3, "alpha": 0.5}], "schedule": {"values": [1, 0.5, 0.25]}, "shifts": 2}]})");
}

json solid() {
  return json::parse(R"({"name": "solid", "sweeps": [{
    "shapes": ["sphere:radius=3"], "estimators": ["ii", "ii-covariance"], "evaluations": ["masks", "full"],
    "radii": [{"k": 1.5}], "schedule": {"values": [1, 0.5]}, "shifts": 2, "rotate": true}]})");
}

std::vector<Record> run(const json& study, const RunOptions& options = {}) {
  return run_study(Study::read(study, "test.json"), study, options);
}

/// What a study decides: all but the timings, and for comparisons of evaluations all but the work too.
std::string numbers(Record record, bool with_work = true) {
  record.seconds_digitize = record.seconds_truth = record.seconds_init = record.seconds_eval = 0;
  if (!with_work) {
    record.work = {};
    record.evaluation.clear();
  }
  return to_json(record).dump();
}

std::vector<std::string> numbers(const std::vector<Record>& records) {
  std::vector<std::string> result;
  for (const Record& record : records) result.push_back(numbers(record));
  return result;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string dumped(const std::string& canonical, double noise, double h, int shift, double k,
                   const std::string& estimator, const std::string& evaluation) {
  return json{canonical, noise, h, shift, k, estimator, evaluation}.dump();
}

TEST(RunStudy, GoesThroughEveryCombinationInTheDocumentedOrder) {
  json study = flat();
  study["sweeps"][0]["noise"] = {0, 0.1};
  study["sweeps"].push_back(solid()["sweeps"][0]);
  std::vector<std::string> expected, found;
  for (const char* shape : {"disk:radius=5", "ellipse:a=6,b=3,angle=0"})
    for (const double noise : {0.0, 0.1})
      for (const double h : {1.0, 0.5, 0.25})
        for (const int shift : {0, 1})
          for (const double k : {2.0, 3.0})
            for (const char* evaluation : {"full", "masks"})
              expected.push_back(dumped(shape, noise, h, shift, k, "ii", evaluation));
  for (const double h : {1.0, 0.5})
    for (const int shift : {0, 1})
      for (const char* estimator : {"ii", "ii-covariance"})
        for (const char* evaluation : {"masks", "full"})
          expected.push_back(dumped("sphere:radius=3", 0, h, shift, 1.5, estimator, evaluation));
  for (const Record& r : run(study))
    found.push_back(dumped(r.shape, r.noise, r.h, r.shift, r.k, r.estimator, r.evaluation));
  EXPECT_EQ(found, expected);
}

TEST(RunStudy, FillsARecord) {
  for (const Record& r : run(flat())) {
    EXPECT_EQ(r.dimension, 2);
    EXPECT_EQ(r.centre, "spels");
    EXPECT_DOUBLE_EQ(r.digital_radius, r.k * std::pow(r.h, r.alpha) / r.h);
    ASSERT_EQ(r.offset.size(), 2u);
    for (const double x : r.offset) EXPECT_LE(std::abs(x), 1);
    EXPECT_EQ(r.singular, 0);
    EXPECT_EQ(r.far, 0);
    EXPECT_EQ(r.components, 1);
    EXPECT_GT(r.work.evaluations, 0);
    EXPECT_GT(r.work.cells_visited, 0);
    EXPECT_GT(r.seconds_digitize, 0);
    EXPECT_GT(r.seconds_eval, 0);
    ASSERT_EQ(r.errors.size(), 1u);
    EXPECT_EQ(r.errors[0].first, "kappa");
    const ErrorNorms& norms = r.errors[0].second;
    EXPECT_EQ(std::int64_t(norms.count), r.surfels);
    EXPECT_LT(0, norms.mean);
    EXPECT_LE(norms.mean, norms.rms);
    EXPECT_LE(norms.rms, norms.sup);
  }
}

TEST(RunStudy, ComparesWithTheTruthOfTheSameSurfel) {
  // Curvature along this flower spreads by 0.087 around its mean: estimates compared with the truth of other
  // surfels would be off by that much at least. Half of it leaves room for the estimator's own error.
  json study = flat();
  study["sweeps"][0]["shapes"] = {"flower:radius=20,amplitude=7,petals=3"};
  study["sweeps"][0]["radii"] = {{{"k", 5}}};
  study["sweeps"][0]["schedule"] = {{"values", {0.05, 0.02}}};
  study["sweeps"][0]["evaluations"] = {"masks"};
  for (const Record& r : run(study)) EXPECT_LT(r.errors.at(0).second.rms, 0.087 / 2) << to_json(r);
}

TEST(RunStudy, HasTheQuantitiesOfTheTheoryIn3D) {
  for (const Record& r : run(solid())) {
    std::vector<std::string> names;
    for (const auto& [quantity, norms] : r.errors) {
      names.push_back(quantity);
      EXPECT_EQ(std::int64_t(norms.count), r.surfels);
    }
    EXPECT_FALSE(names.empty());
    if (r.estimator == "ii") {
      EXPECT_EQ(names, std::vector<std::string>{"mean"});
    }
    EXPECT_EQ(r.offset.size(), 3u);
  }
}

TEST(RunStudy, DoesNotDependOnThreads) {
  for (const json& study : {flat(), solid()}) {
    std::vector<std::string> of[2];
    for (const std::size_t threads : {1, 2}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      of[threads - 1] = numbers(run(study));
    }
    EXPECT_EQ(of[0], of[1]);
  }
}

TEST(RunStudy, HasTheSameErrorsForBothEvaluations) {
  for (const json& study : {flat(), solid()}) {
    const std::vector<Record> records = run(study);
    for (std::size_t i = 0; i < records.size(); i += 2) {
      ASSERT_NE(records[i].evaluation, records[i + 1].evaluation);
      EXPECT_EQ(numbers(records[i], false), numbers(records[i + 1], false));
      EXPECT_NE(records[i].work.cells_visited, records[i + 1].work.cells_visited);
    }
  }
}

TEST(RunStudy, TimesOnOneThreadWithoutChangingNumbers) {
  json timed = flat();
  timed["timing"] = true;
  EXPECT_EQ(numbers(run(timed)), numbers(run(flat())));
}

TEST(RunStudy, ShiftsAndNoiseComeFromTheSeed) {
  json study = flat();
  study["sweeps"][0]["noise"] = {0.2};
  const std::vector<Record> first = run(study);
  EXPECT_EQ(numbers(first), numbers(run(study)));
  EXPECT_NE(first.front().offset, first.back().offset);
  study["seed"] = 2;
  const std::vector<Record> second = run(study);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_NE(first[i].offset, second[i].offset);
}

TEST(RunStudy, PlacesShapesAlikeWhateverElseTheStudyHolds) {
  // Placements belong to the step and the shift: curves of different shapes can be compared point by point.
  json alone = flat();
  alone["sweeps"][0]["shapes"] = {"ellipse:a=6,b=3"};
  const std::vector<std::string> both = numbers(run(flat())), one = numbers(run(alone));
  EXPECT_EQ(std::vector<std::string>(both.end() - std::ptrdiff_t(one.size()), both.end()), one);
}

TEST(RunStudy, RotatesOnRequestAlone) {
  json study = flat();
  study["sweeps"][0]["shapes"] = {"ellipse:a=6,b=3"};
  const std::vector<Record> straight = run(study);
  study["sweeps"][0]["rotate"] = true;
  const std::vector<Record> rotated = run(study);
  EXPECT_EQ(straight.back().offset, rotated.back().offset);
  EXPECT_NE(numbers(straight.back()), numbers(rotated.back()));
}

TEST(RunStudy, RecordsTheCentre) {
  json study = flat();
  const std::vector<Record> spels = run(study);
  study["sweeps"][0]["centre"] = "surfel";
  const std::vector<Record> surfel = run(study);
  EXPECT_EQ(surfel.front().centre, "surfel");
  EXPECT_NE(spels.front().errors[0].second.sup, surfel.front().errors[0].second.sup);
}

TEST(RunStudy, CountsComponentsOfNoisyBoundaries) {
  json study = flat();
  study["sweeps"][0]["noise"] = {0.5};
  std::int64_t most = 0;
  for (const Record& r : run(study)) {
    EXPECT_EQ(r.noise, 0.5);
    EXPECT_GE(r.components, 1);
    most = std::max(most, r.components);
    EXPECT_EQ(std::int64_t(r.errors.at(0).second.count), r.surfels - r.singular - r.far);
  }
  EXPECT_GT(most, 1);
}

TEST(RunStudy, LeavesSurfelsAtEdgesOut) {
  json study = solid();
  study["sweeps"][0]["shapes"] = {"cube"};  // rotated: some centres lie outside, beyond an edge
  for (const Record& r : run(study)) {
    EXPECT_EQ(std::int64_t(r.errors.at(0).second.count), r.surfels - r.singular);
    EXPECT_GT(r.singular, 0);
    EXPECT_LT(r.singular, r.surfels);
  }
}

TEST(RunStudy, NamesAShapeThatIsTooSmall) {
  const TemporaryFolder folder;
  const std::filesystem::path journal = folder.path() / "journal.jsonl";
  json study = flat();
  study["sweeps"][0]["shapes"] = {"disk:radius=0.01"};
  EXPECT_EQ(failure_of([&] {
              run(study, {journal, false, nullptr});
            }),
            "disk:radius=0.01: h = 1: the digital set is empty; the grid step is coarser than the shape");
  EXPECT_FALSE(std::filesystem::exists(journal)) << "it would only stand in the way of the corrected study";
}

TEST(RunStudy, RefusesWhatDoesNotFitInMemoryBeforeAnythingStarts) {
  const TemporaryFolder folder;
  const std::filesystem::path journal = folder.path() / "journal.jsonl";
  json study = solid();
  study["sweeps"].push_back(study["sweeps"][0]);
  study["sweeps"][1]["schedule"]["values"] = {1, 1e-7};
  const std::string message = failure_of([&] { run(study, {journal, false, nullptr}); });
  EXPECT_TRUE(message.starts_with("sphere:radius=3 at h = 1e-07: needs about ")) << message;
  EXPECT_FALSE(std::filesystem::exists(journal));

  std::ofstream(journal) << "of another run";
  EXPECT_EQ(failure_of([&] { run(study, {journal, true, nullptr}); }).substr(0, 15), "sphere:radius=3");
  EXPECT_EQ(content_of(journal), "of another run");
}

class StudyJournal : public testing::Test {
 protected:
  StudyJournal() {
    study_["sweeps"][0]["shifts"] = 1;
    study_["sweeps"][0]["schedule"]["values"] = {1, 0.5};
  }
  std::vector<std::string> resumed() { return numbers(run(study_, {journal_, true, nullptr})); }

  json study_ = flat();
  const TemporaryFolder folder_;
  const std::filesystem::path journal_ = folder_.path() / "journal.jsonl";
};

TEST_F(StudyJournal, GoesOnFromEveryLineAndEveryHalfLine) {
  const std::vector<std::string> expected = numbers(run(study_, {journal_, false, nullptr}));
  EXPECT_EQ(expected, numbers(run(study_))) << "with and without a journal";
  const std::string whole = content_of(journal_);
  const std::vector<std::string> lines = lines_of(whole);
  ASSERT_EQ(lines.size(), 5u) << "a header and one line a digitization";
  std::string kept;
  for (const std::string& line : lines) {
    for (const std::string& cut : {kept, kept + line.substr(0, line.size() / 2), kept + line}) {
      std::ofstream(journal_, std::ios::trunc) << cut;
      EXPECT_EQ(resumed(), expected) << cut.size() << " bytes";
      EXPECT_EQ(lines_of(content_of(journal_)).size(), lines.size());
      EXPECT_TRUE(content_of(journal_).starts_with(kept));
    }
    kept += line + "\n";
  }
  std::ofstream(journal_, std::ios::trunc) << whole;
  EXPECT_EQ(resumed(), expected) << "nothing left to do";
  EXPECT_EQ(content_of(journal_), whole);
}

TEST_F(StudyJournal, IsReadAndNotRepeated) {
  run(study_, {journal_, false, nullptr});
  std::string text = content_of(journal_);
  const std::size_t at = text.find("\"surfels\":");
  ASSERT_NE(at, std::string::npos);
  text.insert(at + 10, 1, '9');
  std::ofstream(journal_, std::ios::trunc) << text;
  EXPECT_GT(run(study_, {journal_, true, nullptr}).front().surfels, 90);
}

TEST_F(StudyJournal, ResumesFromNothing) {
  EXPECT_EQ(resumed(), numbers(run(study_)));
}

TEST_F(StudyJournal, IsNotOverwrittenUnasked) {
  run(study_, {journal_, false, nullptr});
  const std::string before = content_of(journal_);
  EXPECT_EQ(failure_of([&] {
              run(study_, {journal_, false, nullptr});
            }),
            journal_.string() +
                ": an unfinished run of a study; --resume goes on with it, removing the file starts anew");
  EXPECT_EQ(content_of(journal_), before);
}

TEST_F(StudyJournal, OfAnotherStudyOrSeedIsRefused) {
  run(study_, {journal_, false, nullptr});
  const std::string before = content_of(journal_);
  for (const char* patch : {R"({"seed": 2})", R"({"description": "another"})"}) {
    json other = study_;
    other.merge_patch(json::parse(patch));
    const std::string message = failure_of([&] { run(other, {journal_, true, nullptr}); });
    EXPECT_TRUE(message.starts_with(journal_.string() + ": not the journal of this study")) << message;
    EXPECT_EQ(content_of(journal_), before);
  }
}

TEST_F(StudyJournal, WithWhatIsNoRecordIsRefused) {
  run(study_, {journal_, false, nullptr});
  const std::string header = lines_of(content_of(journal_)).front();
  for (const char* line : {R"([{"shape": "disk"}])", R"({"shape": "disk"})", "[3]", "[]"}) {
    std::ofstream(journal_, std::ios::trunc) << header << "\n" << line << "\n";
    EXPECT_NE(failure_of([&] { run(study_, {journal_, true, nullptr}); }), "no failure") << line;
  }
  std::ofstream(journal_, std::ios::trunc) << header << "\n";
  run(study_, {journal_, true, nullptr});
  const std::string longer = lines_of(content_of(journal_)).back();
  std::ofstream(journal_, std::ios::app) << longer << "\n";
  EXPECT_NE(failure_of([&] { run(study_, {journal_, true, nullptr}); }), "no failure") << "a job too many";
}

TEST(RunStudy, TellsItsProgress) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "progress";
  std::FILE* stream = std::fopen(file.c_str(), "w");
  ASSERT_NE(stream, nullptr);
  run(flat(), {{}, false, stream});
  std::fclose(stream);
  EXPECT_NE(content_of(file).find("100"), std::string::npos) << content_of(file);
}

}  // namespace
}  // namespace gridstep
