#include "experiments/report/base64.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace gridstep {
namespace {

std::string of(std::string_view text) {
  return base64(std::as_bytes(std::span(text)));
}

TEST(Base64, IsThatOfTheStandard) {  // the examples of RFC 4648, section 10
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foob"), "Zm9vYg==");
  EXPECT_EQ(of("fooba"), "Zm9vYmE=");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(of("\xff\xff\xfe"), "///+");
}

TEST(Base64, OfNumbersTakesTheirBytes) {
  EXPECT_EQ(base64(std::vector<float>{1.0f}), "AACAPw==");
  EXPECT_EQ(base64(std::vector<std::uint16_t>{1, 0x0203}), "AQADAg==");
}

}  // namespace
}  // namespace gridstep
