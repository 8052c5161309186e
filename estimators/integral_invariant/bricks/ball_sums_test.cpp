#include "estimators/integral_invariant/bricks/ball_sums.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "estimators/integral_invariant/bricks/ball_rows.hpp"
#include "estimators/integral_invariant/bricks/targets.hpp"
#include "estimators/integral_invariant/bricks/testing_cases.hpp"
#include "estimators/integral_invariant/surfel_sums.hpp"

namespace gridstep::bricks {
namespace {

using Count2 = PlainSum<2, std::int64_t>;
using Count3 = PlainSum<3, std::int64_t>;
using Moments3 = MomentSums<3, std::int64_t>;

/// The tests that compare sums run on every target of this processor.
class OnTarget : public testing::TestWithParam<std::string> {
 protected:
  OnTarget() { use_target(GetParam()); }
  ~OnTarget() override { use_target(targets().front().name); }
};

std::vector<std::string> target_names() {
  std::vector<std::string> names;
  for (const Target& one : targets()) names.push_back(one.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(BrickSums, OnTarget, testing::ValuesIn(target_names()), [](const auto& tested) {
  std::string name = tested.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

template <int d>
void expect_equal_to_full(const RandomBall& ball, const RandomSet<d>& set) {
  const Evaluations<PlainSum<d, std::int64_t>, d> counts(ball);
  const Evaluations<MomentSums<d, std::int64_t>, d> moments(ball);
  const std::string where =
      fmt::format("{} in {}D, R/h = {}, half axis {}", set.kind, d, ball.radius.value, ball.half_axis);
  EXPECT_TRUE(counts.bricks(set) == counts.full(set)) << where;
  EXPECT_TRUE(moments.bricks(set) == moments.full(set)) << where;
}

void expect_equal_to_full(std::uint64_t seed, int largest_in_2d, int largest_in_3d, std::size_t spels) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  RandomStream random({seed});
  const RandomBall disk = random_ball<2>(random, largest_in_2d), ball = random_ball<3>(random, largest_in_3d);
  // Some of these sets hold the ball, with bricks all around its boundary.
  expect_equal_to_full(disk, random_set<2>(random, 16 + 3 * largest_in_2d, spels));
  expect_equal_to_full(ball, random_set<3>(random, 16 + 2 * largest_in_3d, spels));
}

TEST_P(OnTarget, BrickSumsEqualTheFullKernelOnRandomSets) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) expect_equal_to_full(seed, 60, 12, 40);
}

TEST_P(OnTarget, BrickSumsEqualTheFullKernelForLargeBalls) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) expect_equal_to_full(seed, 700, 60, 8);
}

TEST_P(OnTarget, BrickSumsOfNearlyFullBricksFitTheirCounters) {
  // Every brick is mixed and has as many points as it may: a hole each.
  RandomSet<3> one{DigitalSet<3>({LatticePoint<3>::Constant(-168), LatticePoint<3>::Constant(175)}),
                   {{0, 0, 0}, {4, 3, 7}, {7, 7, 7}},
                   "holes"};
  Brick<3> nearly_full = Brick<3>::full();
  nearly_full.set(0, false);
  for_each_point(one.set.brick_box(),
                 [&](const LatticePoint<3>& brick) { one.set.set_brick(brick, nearly_full); });
  // As many bricks in a row, and as many rows, as there may be.
  constexpr int R = 160;
  const auto counts = brick_sums(BallSums<3, Count3>({R}, -1), one);
  const auto moments = brick_sums(BallSums<3, Moments3>({R}, -1), one);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    Moments3 expected;
    for (int z = -R; z <= R; ++z)
      for (int y = -R; y <= R; ++y) {
        const int rest = R * R - y * y - z * z, most = rest < 0 ? -1 : int(std::sqrt(double(rest)));
        for (int x = -most; x <= most; ++x) {
          const LatticePoint<3> point = one.spels[i] + LatticePoint<3>(x, y, z);
          if (((point[0] | point[1] | point[2]) & 7) != 0) expected.add(1, {x, y, z});
        }
      }
    EXPECT_TRUE(moments[i] == expected) << "spel " << i;
    EXPECT_EQ(counts[i].n, expected.n);
  }
}

template <int d>
struct HugeBalls {
  double R;
  int half_axis;
  BallSums<d, MomentSums<d, std::int64_t>> moments{{R}, half_axis};
  BallSums<d, PlainSum<d, std::int64_t>> counts{{R}, half_axis};
};

/// Compares with the definition, by the target in use, over noise that is full where y < y_of_noise.
template <int d>
void expect_the_definition(const HugeBalls<d>& balls, const LatticeBox<d>& box, RandomStream& random,
                           int y_of_noise = 0) {
  const LatticePoint<d> last = Brick<d>::offset(Brick<d>::kBits - 1);
  RandomSet<d> one{DigitalSet<d>(box), {LatticePoint<d>::Zero(), last / 2, last}, "half noise"};
  for_each_point(box, [&](const LatticePoint<d>& z) {
    if (z[1] < y_of_noise || random.below(2) == 0) one.set.set(z, true);
  });
  std::vector<MomentSums<d, std::int64_t>> expected(one.spels.size());
  for_each_point(box, [&](const LatticePoint<d>& z) {
    if (!one.set.contains(z)) return;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const LatticePoint<d> offset = z - one.spels[i];
      RealPoint<d> from_centre = offset.template cast<double>();
      if (balls.half_axis == 0) from_centre[0] -= 0.5;
      if (from_centre.squaredNorm() <= balls.R * balls.R) expected[i].add(1, offset);
    }
  });
  const auto moments = brick_sums(balls.moments, one);
  const auto counts = brick_sums(balls.counts, one);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_TRUE(moments[i] == expected[i]) << "half axis " << balls.half_axis << ", spel " << i;
    EXPECT_EQ(counts[i].n, expected[i].n);
  }
}

TEST_P(OnTarget, BrickSumsAreThoseOfTheDefinitionForHugeBalls) {
  // Where rows of the middle have so many bricks on a side that other rows follow them: near the poles, the ball's own or
  // full ones; and where the ball is as steep as the rows.
  const LatticeBox<3> cap{{-170, -20, 205}, {170, 3, 260}}, right_of_cap{{8, -20, 205}, {170, 3, 260}},
      left_of_cap{{-170, -20, 205}, {-1, 3, 260}}, right{{140, 0, 140}, {240, 12, 180}},
      left{{-240, 0, 140}, {-140, 12, 180}};
  for (const int half_axis : {-1, 0}) {
    const HugeBalls<3> balls{246.9, half_axis};
    RandomStream random({std::uint64_t(half_axis + 1)});
    for (const LatticeBox<3>& box : {cap, right_of_cap, left_of_cap, right, left})
      expect_the_definition(balls, box, random);
  }
}

TEST_P(OnTarget, BrickSumsAreThoseOfTheDefinitionForHugeDisks) {
  const LatticeBox<2> cap{{-1500, 15850}, {1500, 15910}}, right{{15700, -40}, {15960, 100}},
      left{{-15960, -40}, {-15700, 100}}, steep{{11100, 11200}, {11400, 11300}};
  for (const int half_axis : {-1, 0}) {
    const HugeBalls<2> disks{15900.3, half_axis};
    RandomStream random({std::uint64_t(half_axis + 1)});
    for (const LatticeBox<2>& box : {cap, right, left, steep})
      expect_the_definition(disks, box, random, (box.lo[1] + box.hi[1]) / 2);
  }
}

TEST(BrickSums, AreThoseOfTheDefinitionWhereSidesHaveSeveralParts) {
  const LatticeBox<3> right{{1, -9, 376}, {140, 20, 399}}, left{{-140, -9, 376}, {-1, 20, 399}};
  for (const int half_axis : {-1, 0}) {
    const HugeBalls<3> balls{400, half_axis};
    const BallRows<3> rows({balls.R}, half_axis);
    EXPECT_TRUE(std::any_of(rows.sides().begin(), rows.sides().end(), [&](const auto& row) {
      return row.parts > 1 && right.contains(Brick<3>::origin(row.brick) + LatticePoint<3>(8, 0, 0));
    }));
    RandomStream random({std::uint64_t(half_axis + 1)});
    for (const Target& target : targets()) {
      use_target(target.name);
      for (const LatticeBox<3>& box : {right, left}) expect_the_definition(balls, box, random);
    }
    use_target(targets().front().name);
  }
}

TEST(BallRows, HoldEveryBrickOnce) {
  for (const double R : {9.0, 250.0, 500.0}) {
    const BallRows<3> ball({R}, -1);
    int split = 0;
    std::map<std::pair<int, int>, int> reached;  // by rows so far
    const auto check = [&](const BallRows<3>::Row& row, bool in_middle) {
      const auto [found, is_first] = reached.try_emplace({row.brick[1], row.brick[2]}, row.reach);
      split += !is_first;
      EXPECT_EQ(row.near == 0, in_middle);
      EXPECT_EQ(row.whole, is_first && row.near > 0);
      if (!is_first) {
        EXPECT_EQ(row.near, std::exchange(found->second, row.reach) + 1);
      }
      EXPECT_LE(row.near, row.reach);
      EXPECT_LE(row.reach, std::max(row.near, 1) + BallRows<3>::kMostBricks - 1);
      EXPECT_LE(64 * ((row.reach + 1) * (row.reach + 1) - row.near * row.near), 16383);
    };
    for (const auto& row : ball.middle()) check(row, true);
    for (const auto& row : ball.sides()) check(row, false);
    EXPECT_EQ(ball.middle().size() + ball.sides().size(), ball.rows().size());
    EXPECT_EQ(split > 0, R > 9);
    // A whole row and its parts are all that is there of the row, and lie side by side.
    std::map<std::pair<int, int>, int> rows;
    for (const auto& row : ball.rows()) ++rows[{row.brick[1], row.brick[2]}];
    for (std::size_t i = 0; i < ball.sides().size(); ++i) {
      const auto& row = ball.sides()[i];
      if (!row.whole) continue;
      EXPECT_EQ(row.parts, (rows[{row.brick[1], row.brick[2]}]));
      for (std::size_t part = 0; part < std::size_t(row.parts); ++part)
        EXPECT_EQ(ball.sides()[i + part].brick, row.brick);
    }
  }
}

/// All points of a box of whole pages, or of those from `first` to `last` along x: no brick is stored.
template <int d>
DigitalSet<d> full_pages(int pages, int first = 0, int last = std::numeric_limits<int>::max()) {
  const int side = DigitalSet<d>::kPageSide * Brick<d>::extent(0);
  DigitalSet<d> set({LatticePoint<d>::Zero(), LatticePoint<d>::Constant(pages * side - 1)});
  LatticeBox<d> box = set.page_box();
  box.lo[0] = std::max(box.lo[0], first);
  box.hi[0] = std::min(box.hi[0], last);
  set.fill_pages(box);
  return set;
}

TEST(Stretch, HasExactSumsForAnyLength) {
  __extension__ typedef unsigned __int128 Wide;
  for (const std::int64_t first : {0, 5, -500'000'000})
    for (const std::int64_t length : {0, 1, 2, 3, 64, 2'000'000, 3'000'001, 2'000'000'000}) {
      const Wide n = Wide(length), start = Wide(first), triangle = length > 0 ? n * (n - 1) / 2 : 0,
                 squares = triangle * (2 * n - 1) / 3;
      const Stretch stretch(first, length);
      EXPECT_EQ(stretch.n, std::uint64_t(n));
      EXPECT_EQ(stretch.x, std::uint64_t(n * start + triangle)) << first << ' ' << length;
      EXPECT_EQ(stretch.xx, std::uint64_t(n * start * start + 2 * start * triangle + squares))
          << first << ' ' << length;
    }
}

TEST(BrickSums, HaveNoLimitThatStudiesWouldMeet) {
  // Far inside a full set the sum is the number of points of the ball, by rows of the sphere of radius 500.
  std::int64_t points = 0;
  for (std::int64_t z = -500; z <= 500; ++z)
    for (std::int64_t y = -500; y <= 500; ++y)
      if (const std::int64_t rest = 250000 - y * y - z * z; rest >= 0)
        points += 2 * std::int64_t(std::sqrt(double(rest))) + 1;
  const auto space = full_pages<3>(17);
  SpelsByBrick<3> spels;
  SpelsByBrick<3>::Memo memo;
  spels.insert({541, 544, 550}, memo);
  spels.number();
  const BallSums<3, Count3> balls({500}, -1);
  EXPECT_EQ(balls.ball_size(), points);
  EXPECT_EQ(balls.eval(space, spels).front().n, points);

  std::int64_t disk = 0;
  for (std::int64_t y = -2000; y <= 2000; ++y) disk += 2 * std::int64_t(std::sqrt(4e6 - double(y * y))) + 1;
  const auto plane = full_pages<2>(2);
  SpelsByBrick<2> pixels;
  SpelsByBrick<2>::Memo pixel_memo;
  pixels.insert({2047, 2049}, pixel_memo);
  pixels.number();
  const BallSums<2, Count2> disks({2000}, -1);
  EXPECT_EQ(disks.ball_size(), disk);
  EXPECT_EQ(disks.eval(plane, pixels).front().n, disk);
}

/// The points of a ball with first <= x <= last, offsets taken from the spel.
template <int d>
MomentSums<d, std::int64_t> slab_of_ball(int R, double centre, int first, int last) {
  MomentSums<d, std::int64_t> sum;
  const int reach = d == 3 ? R : 0;
  for (std::int64_t z = -reach; z <= reach; ++z)
    for (std::int64_t y = -R; y <= R; ++y) {
      const auto rest = std::int64_t(R) * R - y * y - z * z;
      if (rest < 0) continue;
      const double half = std::sqrt(double(rest));
      const int begin = std::max(first, int(std::ceil(centre - half))),
                end = std::min(last, int(std::floor(centre + half)));
      std::int64_t n = 0, x1 = 0, x2 = 0;
      for (std::int64_t x = begin; x <= end; ++x) {
        ++n;
        x1 += x;
        x2 += x * x;
      }
      if constexpr (d == 2)
        sum.merge({n, {x1, y * n}, {x2, y * x1, y * y * n}}, 1);
      else
        sum.merge({n, {x1, y * n, z * n}, {x2, y * x1, z * x1, y * y * n, y * z * n, z * z * n}}, 1);
    }
  return sum;
}

/// Sides that are full, most of them in several parts: those of one side, and rows from end to end.
template <int d>
void expect_slabs(int R, const LatticePoint<d>& spel) {
  constexpr int kPages = 12, kSide = DigitalSet<d>::kPageSide * Brick<d>::extent(0);
  SpelsByBrick<d> spels;
  typename SpelsByBrick<d>::Memo memo;
  spels.insert(spel, memo);
  spels.number();
  for (const int half_axis : {-1, 0}) {
    const BallSums<d, MomentSums<d, std::int64_t>> balls({double(R)}, half_axis);
    for (const auto& [first, last] : {std::pair(6, kPages - 1), std::pair(0, 5), std::pair(0, kPages - 1)}) {
      const auto expected = slab_of_ball<d>(R, half_axis == 0 ? 0.5 : 0, first * kSide - spel[0],
                                            (last + 1) * kSide - 1 - spel[0]);
      EXPECT_TRUE(balls.eval(full_pages<d>(kPages, first, last), spels).front() == expected)
          << "half axis " << half_axis << ", pages " << first << " to " << last;
    }
  }
}

TEST(BrickSums, AreThoseOfSlabsForHugeBalls) {
  expect_slabs<2>(2800, {3050, 3081});
  expect_slabs<3>(330, {380, 385, 391});
}

TEST(SpelsByBrick, MergesWhatOverlapsInTheOrderInWhichItWasSeen) {
  SpelsByBrick<3> all;
  std::array<SpelsByBrick<3>, 3> slabs;
  std::array<SpelsByBrick<3>::Memo, 4> memos;
  const auto set = ball_set<3>(12);
  std::size_t spels = 0;
  for_each_point(set.domain(), [&](const LatticePoint<3>& z) {
    if (!set.contains(z)) return;
    ++spels;
    all.insert(z, memos[3]);
    for (const int i : {0, 1, 2})
      if (std::abs(z[2] - 8 * (i - 1)) < 6) slabs[std::size_t(i)].insert(z, memos[std::size_t(i)]);
  });
  SpelsByBrick<3>& low = slabs[0];
  const std::size_t before = low.sources().size();
  low.merge({});
  EXPECT_EQ(low.sources().size(), before);
  low.merge(std::span(slabs).subspan(1));
  low.number();
  EXPECT_EQ(low.size(), spels);
  ASSERT_EQ(low.sources().size(), all.sources().size());
  for (std::size_t i = 0; i < all.sources().size(); ++i)
    EXPECT_EQ(low.sources()[i].brick, all.sources()[i].brick);
  memos[0] = {};
  std::vector<bool> seen(spels);
  for_each_point(set.domain(), [&](const LatticePoint<3>& z) {
    if (!set.contains(z)) return;
    const std::size_t position = low.position(z, memos[0]);
    ASSERT_LT(position, spels);
    EXPECT_FALSE(seen[position]);
    seen[position] = true;
  });
}

TEST(BrickSums, AreTheSameForAnyNumberOfThreads) {
  const auto set = ball_set<3>(45);  // more surfels than are grouped at once
  const auto surfels = boundary(set);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    SurfelSums<3, Moments3> sums(set, {Evaluation::bricks, KernelCentre::spels});
    sums.init({1}, {9.5});
    std::vector<std::pair<Moments3, Moments3>> pairs(surfels.size());
    sums.eval(surfels,
              [&](std::size_t i, const Moments3& inner, const Moments3& outer) { pairs[i] = {inner, outer}; });
    return std::pair(pairs, sums.work().cells_visited);
  };
  const auto [one, visited_by_one] = run(1);
  const auto [four, visited_by_four] = run(4);
  EXPECT_EQ(visited_by_one, visited_by_four);
  EXPECT_TRUE(one == four);
}

TEST(BrickSums, AreThoseOfTheirSurfelsBatchByBatch) {
  const auto set = ball_set<3>(110);
  const auto surfels = boundary(set);
  ASSERT_GT(surfels.size(), (std::size_t{16} << 20) / sizeof(Moments3));
  const auto run = [&](Evaluation evaluation) {
    SurfelSums<3, Moments3> sums(set, {evaluation, KernelCentre::spels});
    sums.init({1}, {2});
    std::vector<std::pair<Moments3, Moments3>> pairs(surfels.size());
    sums.eval(surfels, [&](std::size_t i, const Moments3& inner, const Moments3& outer) {
      pairs[i] = {inner, outer};
    });
    return pairs;
  };
  EXPECT_TRUE(run(Evaluation::bricks) == run(Evaluation::masks));
}

TEST(BrickSums, VisitFewBricks) {
  // The curves where ball boundaries cross the set's boundary grow like R; so do the bricks that they meet. The
  // spheres are those of one sphere with R = k h^1/3.
  for (const int R : {8, 16, 24}) {
    const auto set = ball_set<3>(std::pow(R, 1.5));
    const auto surfels = boundary(set);
    SurfelSums<3, Count3> sums(set, {Evaluation::bricks, KernelCentre::spels});
    sums.init({1}, {double(R)});
    sums.eval(surfels, [](std::size_t, const Count3&, const Count3&) {});
    EXPECT_LT(double(sums.work().cells_visited) / double(sums.work().evaluations), 5 * R);
  }
}

TEST(Targets, EndWithThePlainOne) {
  EXPECT_EQ(targets().back().name, "plain");
  EXPECT_THROW(use_target("mmx"), InputError);
}

TEST(BrickSums, TakeTheRadiiOfBallKernel) {
  EXPECT_THROW((BallSums<3, Count3>({0.99}, -1)), InputError);
  EXPECT_THROW((BallSums<3, Count3>({std::nan("")}, -1)), InputError);
  EXPECT_THROW((BallSums<3, Count3>({701}, -1)), InputError);
  EXPECT_THROW((BallSums<2, Count2>({20000}, -1)), InputError);
  EXPECT_THROW((BallSums<2, Count2>({1e300}, -1)), InputError);
  for (const double r : {1.0, 1.4, 2.0, 0.3 / 0.1, 9.0, 17.3})
    for (const int half_axis : {-1, 0, 1, 2})
      EXPECT_EQ((BallSums<3, Count3>({r}, half_axis).ball_size()),
                std::int64_t(ball_kernel<3>({r}, half_axis).size()));
}

}  // namespace
}  // namespace gridstep::bricks
