#include "experiments/core/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <vector>

#include "experiments/core/text.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

std::string content_of(std::FILE* stream) {
  std::rewind(stream);
  std::string text;
  for (int c; (c = std::fgetc(stream)) != EOF;) text += char(c);
  return text;
}

TEST(Progress, WritesALineEveryTenthToAFile) {
  std::FILE* file = std::tmpfile();
  {
    Progress progress(3, file);
    for (int i = 0; i < 1000; ++i) progress.advance(0.003, "flower");
  }
  const std::string text = content_of(file);
  std::fclose(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_TRUE(text.starts_with(" 10% ")) << text;
  EXPECT_NE(text.find("100% "), std::string::npos) << text;
  EXPECT_NE(text.find(" left: flower\n"), std::string::npos) << text;
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST(Progress, LosesNoWorkOfAnyThread) {
  std::FILE* file = std::tmpfile();
  {
    Progress progress(4000, file);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&] {
        for (int i = 0; i < 1000; ++i) progress.advance(1, "torus");
      });
    for (std::thread& thread : threads) thread.join();
  }
  EXPECT_NE(content_of(file).find("100% "), std::string::npos);
  std::fclose(file);
}

TEST(Progress, NeedsWork) {
  EXPECT_THROW(Progress(0, stderr), ContractViolation);
  EXPECT_THROW(Progress(-1, stderr), ContractViolation);
}

std::string read_to_the_end(int descriptor) {
  std::string text;
  char chunk[4096];
  for (ssize_t got; (got = ::read(descriptor, chunk, sizeof chunk)) > 0;)
    text.append(chunk, std::size_t(got));
  return text;
}

/// What a terminal `width` columns wide receives.
std::string on_terminal(unsigned short width, const std::string& what) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0) return "";
  const winsize size{24, width, 0, 0};
  ::ioctl(master, TIOCSWINSZ, &size);
  std::FILE* stream = std::fopen(::ptsname(master), "w");
  if (!stream) return "";
  {
    Progress progress(1000, stream);
    for (int i = 0; i < 1000; ++i) progress.advance(1, what);
  }
  std::fclose(stream);
  // With the other end closed, reading ends in an error once everything has arrived.
  const std::string text = read_to_the_end(master);
  ::close(master);
  return text;
}

TEST(Progress, RedrawsOneLineThatFitsTheTerminal) {
  ::setenv("TERM", "xterm", 1);
  if (on_terminal(80, "x").empty()) GTEST_SKIP() << "no pseudo-terminals here";
  for (const unsigned short width : {10, 40, 80, 200}) {
    const std::string text =
        on_terminal(width, "ellipse κ with a rather long name, h = 0.0123, shift 7 of 10");
    ASSERT_TRUE(text.starts_with("\r"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
    EXPECT_LE(std::count(text.begin(), text.end(), '\r'),
              5);  // first, last, at most one each 0.1 s, end of line
    for (std::size_t begin = 1; begin < text.size();) {
      const std::size_t end = std::min(text.find('\r', begin), text.size());
      EXPECT_LT(display_width(text.substr(begin, end - begin)), width);
      begin = end + 1;
    }
    EXPECT_NE(text.find("100%"), std::string::npos) << text;
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
  }
}

TEST(Progress, WritesPlainLinesToADumbTerminal) {
  ::setenv("TERM", "dumb", 1);
  const std::string text = on_terminal(80, "x");
  ::setenv("TERM", "xterm", 1);
  if (text.empty()) GTEST_SKIP() << "no pseudo-terminals here";
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
}

TEST(Progress, WritesPlainLinesWhereColoursAreUnwanted) {
  ::setenv("TERM", "xterm", 1);
  ::setenv("NO_COLOR", "1", 1);
  const std::string text = on_terminal(80, "x");
  ::unsetenv("NO_COLOR");
  if (text.empty()) GTEST_SKIP() << "no pseudo-terminals here";
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
}

}  // namespace
}  // namespace gridstep
