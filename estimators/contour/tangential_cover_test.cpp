#include "estimators/contour/tangential_cover.hpp"

#include <gtest/gtest.h>

#include "estimators/contour/testing_contours.hpp"

namespace gridstep {
namespace {

/// The longest digital straight segments from each pointel on, by trying all lines.
std::vector<MaximalSegment> longest_segments(const DigitalContour& contour) {
  std::vector<MaximalSegment> longest;
  for (std::ptrdiff_t i = 0; i < contour.size(); ++i) longest.push_back({i, i, {}});
  // A line of least thickness has |a| and |b| at most the extents of its segment.
  for (const auto& [a, b] : primitive_vectors(int(contour.size() / 2)))
    for (MaximalSegment& best : longest) {
      DigitalLine line{a, b, 0};
      line.mu = line.remainder(contour[best.first]);
      std::int64_t highest = line.mu;
      std::ptrdiff_t last = best.first;
      while (true) {
        const std::int64_t r = line.remainder(contour[last + 1]);
        if (std::max(highest, r) - std::min(line.mu, r) >= line.thickness()) break;
        line.mu = std::min(line.mu, r);
        highest = std::max(highest, r);
        ++last;
      }
      const LatticePoint<2> chord = contour[last] - contour[best.first];
      if (last > best.last && b * chord[0] + a * chord[1] > 0) best = {best.first, last, line};
    }
  return longest;
}

/// Those that cannot be extended at the back, either.
std::vector<MaximalSegment> all_maximal_segments(const DigitalContour& contour) {
  const std::vector<MaximalSegment> longest = longest_segments(contour);
  const std::ptrdiff_t n = contour.size();
  std::vector<MaximalSegment> maximal;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t before = longest[std::size_t(contour.index(i - 1))].last - (i == 0 ? n : 0);
    if (longest[std::size_t(i)].last > before) maximal.push_back(longest[std::size_t(i)]);
  }
  return maximal;
}

DigitalContour rectangle(int width, int height) {
  return contours_of(set_where<2>({LatticePoint<2>{0, 0}, LatticePoint<2>{width - 1, height - 1}},
                                  [](const LatticePoint<2>&) { return true; }))[0];
}

class RandomContour : public testing::TestWithParam<int> {
 protected:
  DigitalContour contour = random_contour(std::uint64_t(GetParam()), 4 + 5 * (GetParam() / 4 % 5));
};

TEST_P(RandomContour, AllMaximalSegmentsNoMoreNoFewer) {
  ASSERT_LE(contour.size(), 200);
  const TangentialCover cover(contour);
  const std::vector<MaximalSegment> expected = all_maximal_segments(contour);
  ASSERT_EQ(cover.size(), std::ptrdiff_t(expected.size()));
  for (std::ptrdiff_t k = 0; k < cover.size(); ++k) {
    const MaximalSegment &ours = cover[k], &theirs = expected[std::size_t(k)];
    EXPECT_EQ(ours.first, theirs.first);
    EXPECT_EQ(ours.last, theirs.last);
    EXPECT_EQ(ours.line.a, theirs.line.a);
    EXPECT_EQ(ours.line.b, theirs.line.b);
    EXPECT_EQ(ours.line.mu, theirs.line.mu);
  }
}

TEST_P(RandomContour, MostCentredSegmentOfEveryLinel) {
  const TangentialCover cover(contour);
  const std::ptrdiff_t n = contour.size();
  std::ptrdiff_t covered = 0;
  for (std::ptrdiff_t k = 0; k < cover.size(); ++k) {
    const CyclicRange range = cover.most_centred_for(k);
    EXPECT_LT(range.begin, range.end);
    EXPECT_EQ(range.end, cover.most_centred_for(k + 1).begin);
    covered += range.end - range.begin;
    for (std::ptrdiff_t i = range.begin; i < range.end; ++i) {
      const auto centredness = [&](std::ptrdiff_t m) {
        return std::min(i - cover[m].first, cover[m].last - 1 - i);
      };
      for (std::ptrdiff_t m = k - cover.size(); m <= k + cover.size(); ++m)
        EXPECT_TRUE(m < k ? centredness(k) > centredness(m) : centredness(k) >= centredness(m))
            << i << ' ' << k << ' ' << m;
    }
  }
  EXPECT_EQ(covered, n);
}

TEST_P(RandomContour, SegmentsOfEveryLinel) {
  const TangentialCover cover(contour);
  const std::vector<CyclicRange> ranges = cover.segments_of_linels();
  for (std::ptrdiff_t i = 0; i < contour.size(); ++i) {
    const auto [begin, end] = ranges[std::size_t(i)];
    EXPECT_LE(-cover.size(), begin);
    EXPECT_LT(begin, end);
    EXPECT_LE(end, cover.size());
    for (std::ptrdiff_t k = -2 * cover.size(); k < 2 * cover.size(); ++k)
      EXPECT_EQ(cover[k].first <= i && i + 1 <= cover[k].last, begin <= k && k < end) << i << ' ' << k;
  }
}

TEST_P(RandomContour, DoesNotDependOnTheFirstPointel) {
  const TangentialCover cover(contour);
  for (const std::ptrdiff_t start : {std::ptrdiff_t(1), contour.size() / 3, contour.size() - 1}) {
    const TangentialCover other(started_at(contour, start));
    ASSERT_EQ(other.size(), cover.size());
    std::ptrdiff_t shift = 0;
    while (cover[shift].first < start) ++shift;
    for (std::ptrdiff_t k = 0; k < cover.size(); ++k) {
      EXPECT_EQ(other[k].first, cover[k + shift].first - start);
      EXPECT_EQ(other[k].last, cover[k + shift].last - start);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomContour, testing::Range(0, 60));

TEST(TangentialCover, RectanglesHaveASegmentACornerOrASide) {
  const TangentialCover cell(rectangle(1, 1));
  ASSERT_EQ(cell.size(), 4);
  for (std::ptrdiff_t k = 0; k < 4; ++k) {
    EXPECT_EQ(cell[k].first, k);
    EXPECT_EQ(cell[k].last, k + 2);
    EXPECT_EQ(cell[k].line.thickness(), 2);
  }
  // A side and one linel more, at either end.
  const TangentialCover large(rectangle(7, 5));
  ASSERT_EQ(large.size(), 8);
  for (std::ptrdiff_t k = 0; k < 8; ++k)
    EXPECT_TRUE(large[k].last - large[k].first == 8 || large[k].last - large[k].first == 6);
}

TEST(TangentialCover, RefusesWhatIsNotClosed) {
  DigitalContour contour = rectangle(3, 2);
  contour.pointels.pop_back();
  EXPECT_THROW(TangentialCover{contour}, ContractViolation);
  EXPECT_THROW(TangentialCover{DigitalContour{}}, ContractViolation);
  // There and back again.
  EXPECT_THROW(TangentialCover{(DigitalContour{{{0, 0}, {1, 0}, {2, 0}, {1, 0}}})}, ContractViolation);
}

}  // namespace
}  // namespace gridstep
