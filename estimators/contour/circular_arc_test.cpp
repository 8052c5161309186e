#include "estimators/contour/circular_arc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "estimators/contour/testing_contours.hpp"

namespace gridstep {
namespace {

using Points = std::vector<LatticePoint<2>>;

/// Whether a circle or line has the inner points on one side or on it, and the outer points on the other or on it.
/// The curves (A, B, C, D) of A (x^2 + y^2) + B x + C y + D that do form a convex cone; if it is not {0}, one of its
/// extreme rays goes through three of the points. So these are all tried, in exact integers.
bool separable(const Points& inner, const Points& outer) {
  std::set<std::pair<int, int>> distinct;
  for (const Points* points : {&inner, &outer})
    for (const LatticePoint<2>& p : *points) distinct.emplace(p[0], p[1]);
  if (distinct.size() <= 3) return true;
  struct Lifted {
    std::int64_t x, y, w;
  };
  const LatticePoint<2> origin = inner.front();
  const auto lift = [&](int px, int py) {
    const std::int64_t x = px - origin[0], y = py - origin[1];
    return Lifted{x, y, x * x + y * y};
  };
  std::vector<Lifted> in, out, all;
  for (const LatticePoint<2>& p : inner) in.push_back(lift(p[0], p[1]));
  for (const LatticePoint<2>& q : outer) out.push_back(lift(q[0], q[1]));
  for (const auto& [x, y] : distinct) all.push_back(lift(x, y));
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const Lifted &a = all[i], &b = all[j], &c = all[k];
        const Lifted u{b.x - a.x, b.y - a.y, b.w - a.w}, v{c.x - a.x, c.y - a.y, c.w - a.w};
        const std::int64_t X = u.y * v.w - u.w * v.y, Y = u.w * v.x - u.x * v.w, W = u.x * v.y - u.y * v.x;
        const auto f = [&](const Lifted& p) { return X * (p.x - a.x) + Y * (p.y - a.y) + W * (p.w - a.w); };
        for (const int sign : {1, -1})
          if (std::all_of(in.begin(), in.end(), [&](const Lifted& p) { return sign * f(p) <= 0; }) &&
              std::all_of(out.begin(), out.end(), [&](const Lifted& q) { return sign * f(q) >= 0; }))
            return true;
      }
  return false;
}

/// First linels and sizes, least first linel first, by brute force; one entry of size n where the whole contour is
/// an arc.
std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> arcs_by_brute_force(const DigitalContour& contour) {
  const LinelSides sides(contour);
  const std::ptrdiff_t n = contour.size();
  const auto is_arc = [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    Points inner, outer;
    for (std::ptrdiff_t i = begin; i < end; ++i) {
      inner.push_back(sides.inner[std::size_t(i % n)]);
      outer.push_back(sides.outer[std::size_t(i % n)]);
    }
    return separable(inner, outer);
  };
  if (is_arc(0, n)) return {{0, n}};
  std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> arcs;
  std::ptrdiff_t end = 1;
  while (is_arc(-1 + n, end + 1 + n)) ++end;  // of the arc that begins with linel -1
  for (std::ptrdiff_t begin = 0, end_before = end; begin < n; ++begin, end_before = end) {
    end = std::max(end, begin + 1);
    while (is_arc(begin, end + 1)) ++end;
    if (end > end_before) arcs.emplace_back(begin, end - begin);
  }
  return arcs;
}

TEST(MaximalArcs, AreThoseOfBruteForceAndNoOthers) {
  std::size_t whole = 0, several = 0, linels = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const DigitalContour contour = random_contour(seed, 3 + int(seed % 7));
    linels += std::size_t(contour.size());
    std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> found;
    for (const CircularArc& arc : maximal_arcs(contour)) found.emplace_back(arc.begin, arc.size);
    auto expected = arcs_by_brute_force(contour);
    if (expected.size() == 1) expected[0].first = canonical_start(contour);
    ASSERT_EQ(found, expected) << "seed " << seed;
    ++(expected.size() == 1 ? whole : several);
  }
  EXPECT_GT(whole, 10u);
  EXPECT_GT(several, 40u);
  EXPECT_GT(linels, 3000u);
}

TEST(MaximalArcs, FollowEachOtherAround) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const DigitalContour contour = random_contour(seed, 40);
    const auto arcs = maximal_arcs(contour);
    const std::ptrdiff_t n = contour.size();
    for (std::size_t k = 0; arcs.size() > 1 && k < arcs.size(); ++k) {
      const CircularArc& arc = arcs[k];
      const std::ptrdiff_t next = k + 1 < arcs.size() ? arcs[k + 1].begin : arcs[0].begin + n;
      const std::ptrdiff_t next_size = arcs[(k + 1) % arcs.size()].size;
      ASSERT_LT(arc.begin, next);
      ASSERT_LT(arc.begin + arc.size, next + next_size);
      ASSERT_LE(next, arc.begin + arc.size) << "every linel is in an arc";
      ASSERT_LT(arc.size, n);
    }
  }
}

TEST(MaximalArcs, ADiskIsOneArcOfItsCurvature) {
  for (const double r : {1.0, 4.3, 20.0, 333.3}) {
    const auto contour = contours_of(ball_set<2>(r)).front();
    const auto arcs = maximal_arcs(contour);
    ASSERT_EQ(arcs.size(), 1u) << r;
    EXPECT_EQ(arcs[0].size, contour.size());
    EXPECT_NEAR(arcs[0].curvature, 1 / r, 0.5 / (r * r)) << r;
  }
}

TEST(MaximalArcs, TheHoleInADiskIsConcave) {
  const auto contours = contours_of(complement(ball_set<2>(20.0), {{-30, -30}, {30, 30}}));
  ASSERT_EQ(contours.size(), 2u);
  const auto arcs = maximal_arcs(contours[1]);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_NEAR(arcs[0].curvature, -1 / 20.0, 0.5 / 400);
}

// Far from the pole the predicates need 128 bits: a disk of radius 20 000 is one arc, and an arc no longer when one
// point at its far side is missing.
TEST(MaximalArcs, AreExactFarFromThePole) {
  const int r = 20'000;
  std::vector<LatticePoint<2>> pointels;
  // The contour of the disk {|z| <= r}, by its rows: half-widths change by steps, walked with the disk on the left.
  const auto half_width = [&](std::int64_t y) {
    auto w = std::int64_t(std::sqrt(double(std::int64_t{r} * r - y * y)));
    while (w * w + y * y > std::int64_t{r} * r) --w;
    while ((w + 1) * (w + 1) + y * y <= std::int64_t{r} * r) ++w;
    return int(w);
  };
  const auto walk_to = [&](int x, int y) {  // along x, then along y
    if (pointels.empty()) pointels.push_back({x, y});
    while (pointels.back()[0] != x)
      pointels.push_back({pointels.back()[0] + (x > pointels.back()[0] ? 1 : -1), pointels.back()[1]});
    while (pointels.back()[1] != y)
      pointels.push_back({x, pointels.back()[1] + (y > pointels.back()[1] ? 1 : -1)});
  };
  for (int y = -r; y <= r; ++y) walk_to(half_width(y) + 1, y), walk_to(half_width(y) + 1, y + 1);
  for (int y = r; y >= -r; --y) walk_to(-half_width(y), y + 1), walk_to(-half_width(y), y);
  walk_to(half_width(-r) + 1, -r);
  pointels.pop_back();
  DigitalContour disk{pointels};
  const auto whole = maximal_arcs(disk);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_NEAR(whole[0].curvature, 1.0 / r, 1e-9);
  // Cut off a corner: the pointel between a step along x and one along y moves inwards.
  const std::ptrdiff_t n = disk.size();
  for (std::ptrdiff_t i = n / 3; i < n; ++i) {
    const LatticePoint<2> a = disk.step(i - 1), b = disk.step(i);
    if (a[0] * b[1] - a[1] * b[0] != 1) continue;
    disk.pointels[std::size_t(i)] += b - a;
    break;
  }
  EXPECT_GT(maximal_arcs(disk).size(), 1u);
}

TEST(CanonicalStart, MovesWithTheContour) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const DigitalContour contour = random_contour(seed, 8);
    const std::ptrdiff_t start = canonical_start(contour);
    ASSERT_GE(start, 0);
    ASSERT_LT(start, contour.size());
    const auto turns_from = [](const DigitalContour& c, std::ptrdiff_t from) {
      std::vector<int> turns;
      for (std::ptrdiff_t i = 0; i < c.size(); ++i) {
        const LatticePoint<2> a = c.step(from + i), b = c.step(from + i + 1);
        turns.push_back(a[0] * b[1] - a[1] * b[0]);
      }
      return turns;
    };
    const auto word = turns_from(contour, start);
    for (std::ptrdiff_t i = 0; i < contour.size(); ++i) {
      EXPECT_LE(word, turns_from(contour, i));
      EXPECT_EQ(turns_from(started_at(contour, i), canonical_start(started_at(contour, i))), word);
    }
  }
}

}  // namespace
}  // namespace gridstep
