#include "experiments/core/output_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "experiments/core/testing_files.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / "out.csv";

  std::size_t files_in_folder() const {
    return std::size_t(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }
};

TEST_F(OutputFileTest, WritesTheBytesItIsGiven) {
  const std::string content("a,b\r\n\0\xff\n", 8);
  write_whole(file_, content);
  EXPECT_EQ(content_of(file_), content);
  write_whole(file_, "");
  EXPECT_EQ(content_of(file_), "");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(OutputFileTest, AppearsOnlyWhenCommitted) {
  write_whole(file_, "old");
  {
    OutputFile file(file_);
    file.write("new");
    EXPECT_EQ(content_of(file_), "old");
  }
  EXPECT_EQ(content_of(file_), "old");
  EXPECT_EQ(files_in_folder(), 1u);
  OutputFile file(file_);
  file.write("ne");
  file.write("w");
  file.commit();
  EXPECT_EQ(content_of(file_), "new");
  EXPECT_EQ(files_in_folder(), 1u);
  EXPECT_THROW(file.write("more"), ContractViolation);
  EXPECT_THROW(file.commit(), ContractViolation);
}

TEST_F(OutputFileTest, StreamsMoreThanItsBuffer) {
  const std::string line(1000, 'x');
  std::string all;
  OutputFile file(file_);
  for (int i = 0; i < 5000; ++i) {
    file.write(line);
    all += line;
  }
  file.commit();
  EXPECT_EQ(content_of(file_), all);
}

TEST_F(OutputFileTest, TwoWritersOfOneFileDoNotMix) {
  OutputFile first(file_), second(file_);
  first.write("first");
  second.write("second");
  second.commit();
  first.commit();
  EXPECT_EQ(content_of(file_), "first");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(OutputFileTest, FollowsASymbolicLink) {
  write_whole(file_, "old");
  fs::create_symlink(file_, folder_.path() / "link");
  write_whole(folder_.path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "link"));
  EXPECT_EQ(content_of(file_), "new");
}

TEST_F(OutputFileTest, NamesThePathAndTheReasonOfAFailure) {
  const std::string path = folder_.path().string();
  const auto failure = [](const fs::path& target) {
    return failure_of([&] { write_whole(target, "text"); });
  };
  EXPECT_EQ(failure(path + "/missing/out"),
            path + "/missing/out: cannot be created: No such file or directory");
  EXPECT_EQ(failure(path), path + ": cannot be opened: Is a directory");
  EXPECT_EQ(failure("/proc/out"), "/proc/out: cannot be created: No such file or directory");
  write_whole(file_, "old");
  EXPECT_EQ(failure(file_ / "out"), path + "/out.csv/out: cannot be created: Not a directory");
  EXPECT_EQ(content_of(file_), "old");
}

TEST_F(OutputFileTest, AFullDiskLeavesTheOldFileAndNoOther) {
  write_whole(file_, "old");
  {
    const FileSizeLimit limit(100'000);
    EXPECT_EQ(failure_of([&] { write_whole(file_, std::string(200'000, 'x')); }),
              file_.string() + ": cannot be written: File too large");
    EXPECT_THROW(
        {
          OutputFile file(file_);
          for (int i = 0; i < 2000; ++i) file.write(std::string(1000, 'x'));
        },
        InputError);
  }
  EXPECT_EQ(content_of(file_), "old");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(OutputFileTest, WritesToADeviceWithoutReplacingIt) {
  write_whole("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(failure_of([] { write_whole("/dev/full", "text"); }),
            "/dev/full: cannot be written: No space left on device");
}

TEST_F(OutputFileTest, WorksInTheCurrentFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  write_whole("here", "text");
  fs::current_path(before);
  EXPECT_EQ(content_of(folder_.path() / "here"), "text");
}

}  // namespace
}  // namespace gridstep
