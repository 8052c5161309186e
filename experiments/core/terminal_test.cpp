#include "experiments/core/terminal.hpp"

#include <gtest/gtest.h>

#include "experiments/core/text.hpp"

namespace gridstep {
namespace {

TEST(Fold, LeavesWhatFits) {
  for (const char* text : {"", "\n", "one line", "two\nlines\n", "  indented\n\n  twice\n"})
    EXPECT_EQ(fold(text, 12), text);
}

TEST(Fold, BreaksBetweenWords) {
  EXPECT_EQ(fold("a line of words that is too long\n", 12), "a line of\n  words that\n  is too\n  long\n");
  EXPECT_EQ(fold("  ends here     and goes on", 14), "  ends here\n    and goes\n    on");
  EXPECT_EQ(fold("exactly this", 12), "exactly this");
  EXPECT_EQ(fold("exactly this one", 12), "exactly this\n  one");
  EXPECT_EQ(fold("κκκ κκκ κκκ", 7), "κκκ κκκ\n  κκκ") << "columns, not bytes";
}

TEST(Fold, KeepsLongWordsWhole) {
  EXPECT_EQ(fold("written: results/raw/paper-2d/records.jsonl and more", 16),
            "written:\n  results/raw/paper-2d/records.jsonl\n  and more");
  EXPECT_EQ(fold("averyveryverylongword", 5), "averyveryverylongword");
}

TEST(Fold, LosesNoWordAtAnyWidth) {
  const std::string text = "  --option TEXT      What it says, and κ;\n   more of it\n\nlast  line ";
  const auto words = [](const std::string& s) {
    std::string result;
    for (const char c : s)
      if (c != ' ' && c != '\n') result += c;
    return result;
  };
  for (std::size_t width = 1; width < 80; ++width) EXPECT_EQ(words(fold(text, width)), words(text)) << width;
}

TEST(Terminal, FilesHaveNoWidth) {
  std::FILE* file = std::tmpfile();
  EXPECT_FALSE(line_width(file).has_value());
  EXPECT_FALSE(can_redraw(file));
  std::fclose(file);
}

}  // namespace
}  // namespace gridstep
