#include "experiments/core/journal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "experiments/core/testing_files.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

class JournalTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / "study.journal";
  const ordered_json header_ = {{"study", "sphère"}, {"seed", 1}};

  static ordered_json record(int i) { return {{"part", i}, {"sup", 0.1 / i}, {"note", "line\nbreak"}}; }

  void write_records(int first, int last) {
    Journal journal(file_, header_);
    for (int i = first; i <= last; ++i) journal.append(record(i));
  }
};

TEST_F(JournalTest, KeepsWhatWasAppended) {
  write_records(1, 3);
  write_records(4, 5);
  const Journal journal(file_, header_);
  ASSERT_EQ(journal.records().size(), 5u);
  for (int i = 1; i <= 5; ++i) EXPECT_EQ(journal.records()[std::size_t(i - 1)], record(i));
}

TEST_F(JournalTest, ALineIsInTheFileBeforeAppendReturns) {
  Journal journal(file_, header_);
  EXPECT_EQ(content_of(file_), header_.dump() + "\n");
  journal.append(record(1));
  EXPECT_EQ(content_of(file_), header_.dump() + "\n" + record(1).dump() + "\n");
}

TEST_F(JournalTest, ResumesAfterAKillAtEveryByte) {
  write_records(1, 3);
  const std::string whole = content_of(file_);
  const std::size_t header_size = header_.dump().size() + 1;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    std::ofstream(file_, std::ios::binary) << whole.substr(0, size);
    const std::string kept = whole.substr(0, size);
    const auto lines = std::count(kept.begin(), kept.end(), '\n');
    const int complete = size < header_size ? 0 : int(lines) - 1;
    {
      const Journal journal(file_, header_);
      ASSERT_EQ(journal.records().size(), std::size_t(complete)) << size;
    }
    write_records(complete + 1, 3);
    ASSERT_EQ(content_of(file_), whole) << size;
  }
}

TEST_F(JournalTest, DropsALastLineWithoutItsBytes) {
  write_records(1, 2);
  const std::string whole = content_of(file_);
  std::ofstream(file_, std::ios::binary | std::ios::app) << std::string(20, '\0') + "}\n";
  EXPECT_EQ(Journal(file_, header_).records().size(), 2u);
  EXPECT_EQ(content_of(file_), whole);
}

TEST_F(JournalTest, RefusesAJournalOfAnotherStudyAndLeavesItAlone) {
  write_records(1, 1);
  const std::string whole = content_of(file_);
  EXPECT_EQ(failure_of([&] {
              Journal(file_, {{"study", "torus"}});
            }),
            file_.string() + ": not the journal of this study; its first line is " + header_.dump());
  EXPECT_EQ(content_of(file_), whole);
  for (const std::string other : {"a text without an end of line", "a text\n", "{}"}) {
    std::ofstream(file_) << other;
    EXPECT_THROW(Journal(file_, header_), InputError);
    EXPECT_EQ(content_of(file_), other);
  }
}

TEST_F(JournalTest, NamesABadLineBeforeTheLast) {
  std::ofstream(file_) << header_.dump() << "\n{\"a\": 1}\noops\n{\"a\": 2}\n";
  EXPECT_EQ(failure_of([&] { Journal(file_, header_); }), file_.string() + ": line 3 is no JSON");
}

TEST_F(JournalTest, BelongsToOneProcessAtATime) {
  const Journal journal(file_, header_);
  EXPECT_EQ(failure_of([&] { Journal(file_, header_); }), file_.string() + ": in use by another process");
}

TEST_F(JournalTest, AFullDiskLeavesTheCompleteLines) {
  write_records(1, 2);
  const std::string whole = content_of(file_);
  Journal journal(file_, header_);
  {
    const FileSizeLimit limit(whole.size() + 10);
    EXPECT_EQ(failure_of([&] { journal.append(record(3)); }),
              file_.string() + ": cannot be written: File too large");
    EXPECT_EQ(content_of(file_), whole);
  }
  journal.append(record(3));
  EXPECT_EQ(content_of(file_), whole + record(3).dump() + "\n");
}

TEST_F(JournalTest, NamesThePathThatCannotBeOpened) {
  EXPECT_EQ(failure_of([&] { Journal(folder_.path() / "missing" / "j", header_); }),
            (folder_.path() / "missing" / "j").string() + ": cannot be opened: No such file or directory");
}

TEST_F(JournalTest, TakesLinesFromSeveralThreads) {
  {
    Journal journal(file_, header_);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&journal, t] {
        for (int i = 0; i < 25; ++i) journal.append({{"part", 25 * t + i}});
      });
    for (std::thread& thread : threads) thread.join();
  }
  std::set<int> parts;
  const Journal journal(file_, header_);
  for (const ordered_json& line : journal.records()) parts.insert(line["part"].get<int>());
  EXPECT_EQ(parts.size(), 100u);
}

}  // namespace
}  // namespace gridstep
