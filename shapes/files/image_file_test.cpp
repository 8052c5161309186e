#include "shapes/files/image_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "shapes/digital/boundary.hpp"

namespace gridstep {
namespace {

using namespace std::string_literals;  // bytes may be zero

class ImageFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path); }

  GreyImage read(const std::string& content) const {
    std::ofstream(path, std::ios::binary) << content;
    return read_image(path);
  }
  /// What is said of such a file after its name; empty where it is read.
  std::string error(const std::string& content) const {
    try {
      read(content);
    } catch (const InputError& thrown) {
      const std::string message = thrown.what();
      EXPECT_EQ(message.substr(0, path.size() + 2), path + ": ");
      EXPECT_EQ(message.find('\n'), std::string::npos);
      return message.substr(path.size() + 2);
    }
    return "";
  }

  const std::string path =
      testing::TempDir() + "gridstep_image_" + testing::UnitTest::GetInstance()->current_test_info()->name();
};

using Values = std::vector<std::uint16_t>;

TEST_F(ImageFile, GreyImagesAreReadFromDecimalsAndBytes) {
  for (const std::string& content :
       {"P2 3 2 9 0 1 2 7 8 9"s, "P2\n3\n2\n9\n0 1 2\n7 8 009\n"s, "P5\n3 2\n9\n\x00\x01\x02\x07\x08\x09"s,
        "P5 3 2 9\t\x00\x01\x02\x07\x08\x09"s}) {
    const GreyImage image = read(content);
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(image.values, (Values{0, 1, 2, 7, 8, 9}));
    EXPECT_EQ(image.at(1, 1), 8);
    EXPECT_EQ(image.name, path);
  }
}

TEST_F(ImageFile, ValuesAbove255HaveTwoBytesTheHigherFirst) {
  const Values values{0, 256, 65535, 258};
  EXPECT_EQ(read("P5 2 2 65535\n\x00\x00\x01\x00\xff\xff\x01\x02"s).values, values);
  EXPECT_EQ(read("P2 2 2 65535 0 256 65535 258").values, values);
  EXPECT_EQ(read("P5 2 1 256\n\x01\x00\x00\xff"s).values, (Values{256, 255}));
  EXPECT_EQ(read("P5 2 1 255\n\x01\xff"s).values, (Values{1, 255}));
}

TEST_F(ImageFile, BitmapsAreOneWhereTheyAreBlack) {
  const Values values{1, 0, 1, 0, 1, 1, 0, 0, 1, 1};  // two rows of five
  EXPECT_EQ(read("P1 5 2 1 0 1 0 1\n1 0 0 1 1").values, values);
  EXPECT_EQ(read("P1 5 2\n10101\n10011").values, values);
  EXPECT_EQ(read("P1 5 2\n1010110011").values, values);
  EXPECT_EQ(read("P4 5 2\n\xaf\x98").values, values);  // the bits that fill up a row do not count
  const GreyImage wide = read("P4 9 1\n\x80\x80");
  EXPECT_EQ(wide.values, (Values{1, 0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST_F(ImageFile, CommentsGoToTheEndOfTheirLine) {
  const Values values{35, 10};  // the characters '#' and line end are values, too
  EXPECT_EQ(read("P5 # 9 9\n#\n2# 3\n1\n#255\n#\n99\n#\n"s).values, values);
  EXPECT_EQ(read("P5 2 1 99#comment\n#\n"s).values, values);
  EXPECT_EQ(read("P5#comment\n2 1 99\r#\n"s).values, values);
  EXPECT_EQ(read("P2 2 1 99 # comment\n35 # more\n10").values, values);
  EXPECT_EQ(read("P1 2 1 # comment\n1#0\n0#").values, (Values{1, 0}));
}

TEST_F(ImageFile, WhatFollowsThePixelsIsIgnored) {
  EXPECT_EQ(read("P2 2 1 9 1 2 x").values, (Values{1, 2}));
  EXPECT_EQ(read("P1 2 1 10x").values, (Values{1, 0}));
  EXPECT_EQ(read("P4 2 1\n\x80x").values, (Values{1, 0}));
  EXPECT_EQ(read("P5 2 1 99\n#\nP5 2 1 99\n#\n").values, (Values{35, 10}));
}

TEST_F(ImageFile, OtherFilesAreRefused) {
  const std::string other = "not a PGM or PBM image (P1, P2, P4 or P5)";
  for (const std::string& content : {""s, "P"s, "\n"s, "\nP2 1 1 9 1"s, "P6 1 1 255\n   "s, "P3 1 1 9 1 1 1"s,
                                     "P22 1 9 1 1"s, "\x89PNG\r\n\x1a\n"s, "#"s})
    EXPECT_EQ(error(content), other);
  EXPECT_THROW(read_image(testing::TempDir()), InputError);
  try {
    read_image(path + "_missing");
    FAIL();
  } catch (const InputError& thrown) {
    EXPECT_EQ(thrown.what(), path + "_missing: not found");
  }
}

TEST_F(ImageFile, HeadersAreChecked) {
  EXPECT_EQ(error("P2"), "truncated: no width");
  EXPECT_EQ(error("P2 3 # 4"), "truncated: no height");
  EXPECT_EQ(error("P5 3 4"), "truncated: no maximum value");
  EXPECT_EQ(error("P2 0 4 9"), "width = 0: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P2 00 4 9"), "width = 00: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P4 3 -4"), "height = -4: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P1 3 536870913"), "height = 536870913: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P1 3x 1"), "width = 3x: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P1 99999999999999999999 1"),
            "width = 9999999999999999...: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P1 \x1b[2J\x01 1"), "width = ?[2J?: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P2 1 1 0 0"), "maximum value = 0: must be an integer in [1, 65535]");
  EXPECT_EQ(error("P5 1 1 65536\nxxxx"), "maximum value = 65536: must be an integer in [1, 65535]");
}

TEST_F(ImageFile, PixelsAreChecked) {
  EXPECT_EQ(error("P2 2 2 9 1 2 3 10"), "pixel 1 of row 1 = 10: must be an integer in [0, 9]");
  EXPECT_EQ(error("P2 2 2 9 1 -2 3 9"), "pixel 1 of row 0 = -2: must be an integer in [0, 9]");
  EXPECT_EQ(error("P2 2 2 9 1 2 3.5 9"), "pixel 0 of row 1 = 3.5: must be an integer in [0, 9]");
  EXPECT_EQ(error("P5 2 1 9\n\x09\x0a"), "pixel 1 of row 0 = 10: must be an integer in [0, 9]");
  EXPECT_EQ(error("P5 1 1 256\n\x01\x01"), "pixel 0 of row 0 = 257: must be an integer in [0, 256]");
  EXPECT_EQ(error("P1 2 1 12"), "pixel 1 of row 0 = 2: must be an integer in [0, 1]");
  EXPECT_EQ(error("P1 2 1 /1"), "pixel 0 of row 0 = /: must be an integer in [0, 1]");
}

TEST_F(ImageFile, EveryTruncationIsFound) {
  const std::string files[] = {"P1 3 2\n101 011", "P2 3 2 99\n1 2 3\n4 5 6", "P4 9 2\n\xff\x80\xff\x80",
                               "P5 3 2 255\n......", "P5 3 2 256\n............"s};
  for (std::string content : files) {
    // Values in range, of two bytes each.
    if (content.find("256") != std::string::npos) content.replace(11, 12, "\0.\0.\0.\0.\0.\0."s);
    EXPECT_EQ(error(content), "");
    for (std::size_t length = content.find('\n'); length < content.size(); ++length)
      EXPECT_NE(error(content.substr(0, length)).find("truncated: ends before its "), std::string::npos)
          << content.substr(0, length);
  }
  // Sizes that no memory could hold.
  for (const char* format : {"P1", "P2", "P4", "P5"})
    EXPECT_EQ(error(format + " 536870912 536870912 65535 1 1 1"s),
              "truncated: ends before its 536870912 x 536870912 pixels do");
}

TEST_F(ImageFile, ThresholdKeepsBothBoundsAndTurnsTheYAxisUp) {
  const DigitalSet<2> set = threshold(read("P2 3 2 9  0 1 2  7 8 9"), 2, 8);
  EXPECT_EQ(set.size(), 3);
  EXPECT_TRUE(set.contains({2, 1}));
  EXPECT_TRUE(set.contains({0, 0}));
  EXPECT_TRUE(set.contains({1, 0}));
  EXPECT_EQ(threshold(read("P1 3 1 010"), 1, 1).size(), 1);
}

TEST_F(ImageFile, ThresholdOfNothingIsRefused) {
  const GreyImage image = read("P2 3 2 9  0 1 2  7 8 9");
  for (const auto& [low, high] : {std::pair{3, 6}, {8, 7}, {10, 65535}, {-5, -1}}) {
    try {
      threshold(image, low, high);
      FAIL();
    } catch (const InputError& thrown) {
      EXPECT_EQ(thrown.what(),
                path + ": no pixel in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
    }
  }
}

// Also where the image fills whole bricks and pages of the set.
TEST_F(ImageFile, OutsideOfTheImageIsBackground) {
  for (const auto& [width, height] : {std::pair{3, 2}, {256, 256}, {512, 8}, {1, 1}}) {
    const GreyImage image{"white", width, height, Values(std::size_t(width * height), 255)};
    EXPECT_EQ(boundary(threshold(image, 128, 255)).size(), std::size_t(2 * (width + height)));
  }
}

}  // namespace
}  // namespace gridstep
