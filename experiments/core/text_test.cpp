#include "experiments/core/text.hpp"

#include <gtest/gtest.h>

namespace gridstep {
namespace {

TEST(Text, CountsAndCutsCodePoints) {
  EXPECT_EQ(display_width("κ ± 2√h"), 7u);
  EXPECT_EQ(display_width(""), 0u);
  EXPECT_EQ(cut_to_width("κ±√", 2), "κ±");
  EXPECT_EQ(cut_to_width("κ±√", 3), "κ±√");
  EXPECT_EQ(cut_to_width("κ±√", 9), "κ±√");
  EXPECT_EQ(cut_to_width("κ", 0), "");
}

TEST(Text, FormatsErrorsWithFourSignificantDigits) {
  EXPECT_EQ(format_error(0.0123), "0.01230");
  EXPECT_EQ(format_error(12.3456), "12.35");
  EXPECT_EQ(format_error(1234), "1234");
  EXPECT_EQ(format_error(1.23456e-5), "1.235e-05");
  EXPECT_EQ(format_error(0), "0.000");
}

TEST(Text, FormatsSlopesAndIntervals) {
  EXPECT_EQ(format_slope(1.0 / 3.0), "0.333");
  EXPECT_EQ(format_interval({0.31, 0.3521}), "[0.310, 0.352]");
  EXPECT_EQ(format_interval({}), "-");
}

TEST(Text, FormatsTimes) {
  EXPECT_EQ(format_seconds(0.0452), "45.2 ms");
  EXPECT_EQ(format_seconds(3.214), "3.21 s");
  EXPECT_EQ(format_seconds(59.97), "1 min 00 s");
  EXPECT_EQ(format_seconds(245), "4 min 05 s");
  EXPECT_EQ(format_seconds(7400), "2 h 03 min");
}

}  // namespace
}  // namespace gridstep
