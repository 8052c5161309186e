#include "estimators/contour/straight_segment.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "estimators/contour/testing_contours.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

/// By trying all directions: the line of least thickness with pointels first to last, if there is one.
std::optional<DigitalLine> least_line(const DigitalContour& contour, std::ptrdiff_t first,
                                      std::ptrdiff_t last) {
  static const auto directions = primitive_vectors(120);
  const LatticePoint<2> chord = contour[last] - contour[first];
  for (const auto& [a, b] : directions) {
    if (std::abs(a) + std::abs(b) > last - first) break;
    if (b * chord[0] + a * chord[1] <= 0) continue;
    const DigitalLine through{a, b, 0};
    std::int64_t lowest = through.remainder(contour[first]), highest = lowest;
    for (std::ptrdiff_t i = first; i <= last && highest - lowest < through.thickness(); ++i) {
      lowest = std::min(lowest, through.remainder(contour[i]));
      highest = std::max(highest, through.remainder(contour[i]));
    }
    if (highest - lowest < through.thickness()) return DigitalLine{a, b, lowest};
  }
  return std::nullopt;
}

void expect_equal(const DigitalLine& line, const DigitalLine& expected) {
  EXPECT_EQ(line.a, expected.a);
  EXPECT_EQ(line.b, expected.b);
  EXPECT_EQ(line.mu, expected.mu);
}

// A random walk of both ends: every addition that should succeed does, no other, and the line is the least
// one.
TEST(StraightSegment, IsTheLeastLineAfterAnyAdditionsAndRemovals) {
  int added = 0, removed = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const DigitalContour contour = random_contour(seed, 30);
    RandomStream random({seed, 1});
    std::ptrdiff_t first = random.below(std::uint32_t(contour.size())), last = first;
    StraightSegment segment(contour[first]);
    for (int step = 0; step < 600; ++step) {
      const SegmentEnd end = random.below(2) == 0 ? SegmentEnd::back : SegmentEnd::front;
      const bool front = end == SegmentEnd::front;
      const double eager = step / 100 % 2 == 0 ? 0.8 : 0.4;  // grows, then shrinks
      if (random.uniform() < eager) {
        const bool fits = least_line(contour, first - !front, last + front).has_value();
        ASSERT_EQ(segment.add(end, contour[front ? last + 1 : first - 1]), fits);
        last += fits && front;
        first -= fits && !front;
        added += fits;
        refused += !fits;
      } else if (segment.size() > 1) {
        segment.remove(end);
        last -= front;
        first += !front;
        ++removed;
      }
      ASSERT_EQ(segment.back(), contour[first]);
      ASSERT_EQ(segment.front(), contour[last]);
      ASSERT_EQ(segment.size(), last - first + 1);
      if (first < last) expect_equal(segment.line(), least_line(contour, first, last).value());
      if (HasFailure()) FAIL() << "seed " << seed << ", step " << step;
    }
  }
  EXPECT_GT(added, 2000);
  EXPECT_GT(removed, 2000);
  EXPECT_GT(refused, 500);
}

TEST(StraightSegment, OneOrTwoPointels) {
  StraightSegment segment({3, -2});
  EXPECT_EQ(segment.size(), 1);
  EXPECT_THROW(segment.remove(SegmentEnd::back), ContractViolation);
  EXPECT_TRUE(segment.add(SegmentEnd::back, {3, -1}));  // it goes down
  expect_equal(segment.line(), {-1, 0, -3});
  EXPECT_FALSE(segment.add(SegmentEnd::front, {3, -1}));  // back on itself
  segment.remove(SegmentEnd::front);
  EXPECT_EQ(segment.back(), (LatticePoint<2>{3, -1}));
  EXPECT_EQ(segment.size(), 1);
}

// A digitized line is recognized whole, with its own characteristics, from two periods on.
TEST(StraightSegment, RecognizesADigitizedLine) {
  const DigitalLine line{5, 13, -4};
  LatticePoint<2> p(0, 0);
  while (!line.contains(p)) ++p[1];
  StraightSegment segment(p);
  for (int i = 0; i < 2 * 18; ++i) {
    ++p[0];
    if (!line.contains(p)) p += LatticePoint<2>(-1, 1);
    ASSERT_TRUE(line.contains(p));
    ASSERT_TRUE(segment.add(SegmentEnd::front, p));
  }
  expect_equal(segment.line(), line);
}

}  // namespace
}  // namespace gridstep
