#include "shapes/digital/digital_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

template <int d>
struct Dimension {
  static constexpr int value = d;
};
template <class>
class DigitalSets : public testing::Test {};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(DigitalSets, Dimensions);

template <int d>
struct Raster {
  bool operator()(const LatticePoint<d>& a, const LatticePoint<d>& b) const { return raster_less<d>(a, b); }
};
template <int d>
using PointSet = std::set<LatticePoint<d>, Raster<d>>;

template <int d>
LatticePoint<d> random_point(const LatticeBox<d>& box, RandomStream& random) {
  LatticePoint<d> z;
  for (int k = 0; k < d; ++k) z[k] = box.lo[k] + int(random.below(std::uint32_t(box.hi[k] - box.lo[k] + 1)));
  return z;
}

template <int d>
PointSet<d> points_of(const DigitalSet<d>& set) {
  PointSet<d> points;
  for_each_point_of(set, [&](const LatticePoint<d>& z) {
    EXPECT_TRUE(points.insert(z).second) << "visited twice: " << z.transpose();
  });
  return points;
}

TYPED_TEST(DigitalSets, BehaveLikeASetOfPoints) {
  constexpr int d = TypeParam::value;
  RandomStream random{1};
  for (int trial = 0; trial < 10; ++trial) {
    const int reach = 5 + 12 * trial;  // within a brick, within a page, over several pages
    const LatticeBox<d> box{LatticePoint<d>::Constant(-reach), LatticePoint<d>::Constant(reach + trial)};
    DigitalSet<d> set(box);
    EXPECT_EQ(set.size(), 0);
    PointSet<d> expected;
    for (int i = 0; i < 3000; ++i) {
      const LatticePoint<d> z = random_point<d>(box, random);
      const bool value = random.below(3) != 0;
      set.set(z, value);
      value ? void(expected.insert(z)) : void(expected.erase(z));
    }
    EXPECT_EQ(set.size(), std::int64_t(expected.size()));
    EXPECT_EQ(points_of(set), expected);
    for (int i = 0; i < 3000; ++i) {
      const LatticePoint<d> z = random_point<d>(box, random);
      ASSERT_EQ(set.contains(z), expected.contains(z)) << z.transpose();
    }
  }
}

TYPED_TEST(DigitalSets, TheDomainIsWholePagesAroundTheBox) {
  constexpr int d = TypeParam::value;
  const LatticeBox<d> box{LatticePoint<d>::Constant(-100), LatticePoint<d>::Constant(3)};
  const DigitalSet<d> set(box);
  for (int k = 0; k < d; ++k) {
    const int page = Brick<d>::extent(k) * DigitalSet<d>::kPageSide;
    EXPECT_LE(set.domain().lo[k], -100);
    EXPECT_GE(set.domain().hi[k], 3);
    EXPECT_EQ(set.domain().lo[k] % page, 0);
    EXPECT_EQ((set.domain().hi[k] + 1) % page, 0);
    EXPECT_EQ(set.brick_box().extent()[k] * Brick<d>::extent(k), set.domain().extent()[k]);
    EXPECT_EQ(set.page_box().extent()[k] * page, set.domain().extent()[k]);
  }
}

TYPED_TEST(DigitalSets, NothingIsOutsideTheDomain) {
  constexpr int d = TypeParam::value;
  const LatticeBox<d> box{LatticePoint<d>::Constant(0), LatticePoint<d>::Constant(9)};
  DigitalSet<d> set(box);
  set.fill_pages({set.page_box().lo, set.page_box().lo});
  for (int k = 0; k < d; ++k) {
    LatticePoint<d> z = set.domain().hi;
    EXPECT_TRUE(set.contains(z));
    ++z[k];
    EXPECT_FALSE(set.contains(z));
    EXPECT_THROW(set.set(z, true), ContractViolation);
    EXPECT_EQ(set.state(Brick<d>::of(z)), DigitalSet<d>::kEmpty);
    z = set.domain().lo;
    --z[k];
    EXPECT_FALSE(set.contains(z));
    EXPECT_THROW(set.set(z, true), ContractViolation);
  }
  const LatticePoint<d> far = LatticePoint<d>::Constant(1 << 29);
  EXPECT_FALSE(set.contains(far));
  EXPECT_FALSE(set.contains(-far));
}

TYPED_TEST(DigitalSets, UniformPagesAndBricksAreNotStored) {
  constexpr int d = TypeParam::value;
  const LatticeBox<d> box{LatticePoint<d>::Constant(-300), LatticePoint<d>::Constant(300)};
  DigitalSet<d> set(box);
  set.fill_pages({set.page_box().lo, set.page_box().lo});
  const std::size_t memory = set.memory();
  LatticePoint<d> next = set.page_box().lo;
  ++next[1];
  set.fill_pages({next, next});
  EXPECT_EQ(set.memory(), memory);
  double page_points = 1;
  for (int k = 0; k < d; ++k) page_points *= Brick<d>::extent(k) * DigitalSet<d>::kPageSide;
  EXPECT_EQ(double(set.size()), 2 * page_points);

  // A hole in the full page: the rest of the page stays full.
  const LatticePoint<d> hole = set.domain().lo;
  set.set(hole, false);
  EXPECT_EQ(double(set.size()), 2 * page_points - 1);
  EXPECT_FALSE(set.contains(hole));
  EXPECT_TRUE(set.contains(hole + LatticePoint<d>::Unit(1)));
  EXPECT_GE(set.state(Brick<d>::of(hole)), 0);
  EXPECT_EQ(set.state(Brick<d>::of(hole) + LatticePoint<d>::Unit(0)), DigitalSet<d>::kFull);
  EXPECT_THROW(set.fill_pages(set.page_box()), ContractViolation) << "a stored page cannot be replaced";
  EXPECT_THROW(set.fill_pages(set.page_box().dilated(1)), ContractViolation);

  // A stored brick that becomes uniform still reads right.
  set.set(hole, true);
  EXPECT_EQ(double(set.size()), 2 * page_points);
  EXPECT_EQ(set.brick(Brick<d>::of(hole)), Brick<d>::full());
}

/// An empty set over the pages from `begin` to `end`, excluded, in each direction.
template <int d>
DigitalSet<d> set_of_pages(int begin, int end) {
  LatticeBox<d> box;
  for (int k = 0; k < d; ++k) {
    const int page = Brick<d>::extent(k) * DigitalSet<d>::kPageSide;
    box.lo[k] = begin * page;
    box.hi[k] = end * page - 1;
  }
  return DigitalSet<d>(box);
}

TYPED_TEST(DigitalSets, UniformBooksAreNotStored) {
  constexpr int d = TypeParam::value, side = DigitalSet<d>::kPageSide;
  DigitalSet<d> set = set_of_pages<d>(-2 * side, 2 * side);
  const std::size_t empty = set.memory();
  const LatticePoint<d> book = LatticePoint<d>::Constant(-side);
  set.fill_pages({book, book.array() + (side - 1)});
  EXPECT_EQ(set.memory(), empty);
  const double points = std::pow(side, d) * DigitalSet<d>::kBricksInPage * Brick<d>::kBits;
  EXPECT_EQ(double(set.size()), points);

  // A hole: the rest of its page and of its book stays full.
  const LatticePoint<d> hole = Brick<d>::origin(book * side);
  set.set(hole, false);
  EXPECT_EQ(double(set.size()), points - 1);
  EXPECT_FALSE(set.contains(hole));
  EXPECT_TRUE(set.contains(hole + LatticePoint<d>::Unit(0)));
  EXPECT_GE(set.page_state(book), 0);
  EXPECT_EQ(set.page_state(book + LatticePoint<d>::Unit(0)), DigitalSet<d>::kFull);
  EXPECT_EQ(set.page_state(book - LatticePoint<d>::Unit(0)), DigitalSet<d>::kEmpty);
  EXPECT_THROW(set.fill_pages({book, book.array() + (side - 1)}), ContractViolation);
}

TYPED_TEST(DigitalSets, PagesAreFilledWhereverTheirBoxBegins) {
  constexpr int d = TypeParam::value, side = DigitalSet<d>::kPageSide;
  RandomStream random{7};
  for (int trial = 0; trial < 20; ++trial) {
    DigitalSet<d> set = set_of_pages<d>(3 - side, 2 * side - 3);
    const LatticePoint<d> a = random_point<d>(set.page_box(), random),
                          b = random_point<d>(set.page_box(), random);
    const LatticeBox<d> filled{a.cwiseMin(b), a.cwiseMax(b)};
    set.fill_pages(filled);
    for_each_point(set.page_box(), [&](const LatticePoint<d>& page) {
      ASSERT_EQ(set.page_state(page) == DigitalSet<d>::kFull, filled.contains(page)) << page.transpose();
    });
    EXPECT_EQ(double(set.size()), filled.volume() * DigitalSet<d>::kBricksInPage * Brick<d>::kBits);
  }
}

TYPED_TEST(DigitalSets, RunsOfPagesAreAllThatAreNotEmpty) {
  constexpr int d = TypeParam::value, side = DigitalSet<d>::kPageSide;
  RandomStream random{8};
  DigitalSet<d> set = set_of_pages<d>(3 - side, 3 * side - 3);
  set.fill_pages({LatticePoint<d>::Constant(0), LatticePoint<d>::Constant(side)});
  LatticePoint<d> high = Brick<d>::origin(LatticePoint<d>::Constant(3 * side));
  high[0] = set.domain().hi[0];
  const LatticeBox<d> near{LatticePoint<d>::Constant(-2), high};
  for (int i = 0; i < 300; ++i) {
    set.set(random_point<d>(near, random), false);
    set.set(random_point<d>(near, random), true);
  }
  LatticeBox<d> rows = set.page_box().dilated(1);
  rows.hi[0] = rows.lo[0];
  for_each_point(rows, [&](const LatticePoint<d>& row) {
    LatticePoint<d> first = row;
    first[0] += int(random.below(std::uint32_t(4 * side)));
    const int end = first[0] + int(random.below(std::uint32_t(4 * side)));
    LatticePoint<d> page = first;
    for (const auto& run : set.page_runs(first, end)) {
      for (; page[0] < run.begin; ++page[0]) ASSERT_EQ(set.page_state(page), DigitalSet<d>::kEmpty);
      ASSERT_LT(run.begin, run.end);
      ASSERT_TRUE(run.state == DigitalSet<d>::kFull || run.end == run.begin + 1);
      for (; page[0] < run.end; ++page[0]) ASSERT_EQ(set.page_state(page), run.state);
      const bool goes_on = run.state == DigitalSet<d>::kFull && page[0] < end;
      ASSERT_TRUE(!goes_on || set.page_state(page) != DigitalSet<d>::kFull) << "one run in two";
    }
    for (; page[0] < end; ++page[0]) ASSERT_EQ(set.page_state(page), DigitalSet<d>::kEmpty);
  });
}

TYPED_TEST(DigitalSets, RowsOfPagesAreAllThatHaveBooks) {
  constexpr int d = TypeParam::value, side = DigitalSet<d>::kPageSide;
  DigitalSet<d> set = set_of_pages<d>(3 - side, 3 * side - 3);
  const LatticeBox<d> book{LatticePoint<d>::Constant(0), LatticePoint<d>::Constant(side - 1)};
  const LatticePoint<d> page = LatticePoint<d>::Constant(side + 1);  // of the next book
  set.fill_pages(book);
  set.fill_pages({page, page});
  std::vector<LatticePoint<d>> rows, expected;
  set.for_each_row_of_pages([&](const LatticePoint<d>& row) { rows.push_back(row); });
  LatticeBox<d> all = set.page_box();
  all.hi[0] = all.lo[0];
  for_each_point(all, [&](const LatticePoint<d>& row) {
    const auto others = row.array().template tail<d - 1>();
    if ((others >= 0).all() && (others < side).all()) expected.push_back(row);
    if ((others >= side).all() && (others < 2 * side).all()) expected.push_back(row);
  });
  EXPECT_EQ(rows, expected);
}

TEST(DigitalSet, AThinSetInAWideDomainTakesLittle) {
  const int reach = 1 << 14;
  DigitalSet<3> set({LatticePoint<3>::Constant(-reach), LatticePoint<3>::Constant(reach - 1)});
  for (int x = -reach; x < reach; ++x) set.set({x, 0, 0}, true);
  EXPECT_EQ(set.size(), 2 * reach);
  EXPECT_LT(set.memory(), std::size_t{1} << 23);  // of 2^18 books, and 2^27 pages
}

TYPED_TEST(DigitalSets, ABrickKnowsItsNeighbours) {
  constexpr int d = TypeParam::value;
  RandomStream random{9};
  const LatticeBox<d> box{LatticePoint<d>::Constant(-90), LatticePoint<d>::Constant(90)};
  DigitalSet<d> set(box);
  set.fill_pages({LatticePoint<d>::Constant(-1), LatticePoint<d>::Constant(-1)});
  for (int i = 0; i < 100; ++i) set.set(random_point<d>(box, random), random.below(2) == 0);
  for_each_point(set.brick_box().dilated(2), [&](const LatticePoint<d>& b) {
    const BrickNeighbours<d> neighbours(set, b);
    ASSERT_EQ(neighbours.state(), set.state(b));
    for (int axis = 0; axis < d; ++axis)
      for (const int sign : {-1, +1})
        ASSERT_EQ(neighbours.next(axis, sign), set.state(b + sign * LatticePoint<d>::Unit(axis)));
  });
}

TYPED_TEST(DigitalSets, APageStoredAtOnceIsThatOfItsBricks) {
  constexpr int d = TypeParam::value;
  using Set = DigitalSet<d>;
  RandomStream random{6};
  const LatticeBox<d> box{LatticePoint<d>::Constant(-300), LatticePoint<d>::Constant(300)};
  Set one_by_one(box), at_once(box);
  for (const LatticePoint<d>& page : {one_by_one.page_box().lo, one_by_one.page_box().hi}) {
    const LatticePoint<d> first = page * Set::kPageSide;
    std::vector<std::int32_t> states;
    std::vector<Brick<d>> bricks;
    for_each_point(LatticeBox<d>{first, first.array() + (Set::kPageSide - 1)}, [&](const LatticePoint<d>& b) {
      EXPECT_EQ(Set::index_in_page(b), int(states.size())) << "not in raster order";
      const auto kind = random.below(3);
      Brick<d> bits = kind == 0 ? Brick<d>{} : Brick<d>::full();
      if (kind == 2) bits.words[random.below(8)] = 5;
      states.push_back(kind == 0 ? Set::kEmpty : kind == 1 ? Set::kFull : std::int32_t(bricks.size()));
      if (kind == 2) bricks.push_back(bits);
      one_by_one.set_brick(b, bits);
    });
    at_once.set_page(page, states, bricks);
    EXPECT_THROW(at_once.set_page(page, states, bricks), ContractViolation) << "a page stored twice";
  }
  for_each_point(one_by_one.brick_box(), [&](const LatticePoint<d>& b) {
    ASSERT_EQ(at_once.state(b), one_by_one.state(b));
    ASSERT_EQ(at_once.brick(b), one_by_one.brick(b));
  });
  EXPECT_EQ(at_once.size(), one_by_one.size());
  const std::vector<std::int32_t> too_few(7, Set::kFull);
  EXPECT_THROW(at_once.set_page(one_by_one.page_box().lo.array() + 1, too_few, {}), ContractViolation);
}

TYPED_TEST(DigitalSets, BorderBricksHoldAllPointsWithNeighboursOutside) {
  constexpr int d = TypeParam::value;
  RandomStream random{4};
  const LatticeBox<d> box{LatticePoint<d>::Constant(-90), LatticePoint<d>::Constant(90)};
  DigitalSet<d> set(box);
  set.fill_pages({LatticePoint<d>::Constant(-1), LatticePoint<d>::Constant(-1)});
  for (int i = 0; i < 200; ++i) set.set(random_point<d>(box, random), random.below(2) == 0);
  PointSet<d> bricks;
  for_each_border_brick(set, [&](const LatticePoint<d>& b) { EXPECT_TRUE(bricks.insert(b).second); });
  for_each_point_of(set, [&](const LatticePoint<d>& z) {
    for (int axis = 0; axis < d; ++axis)
      for (const int direction : {-1, +1}) {
        const bool at_border = !set.contains(z + direction * LatticePoint<d>::Unit(axis));
        ASSERT_TRUE(!at_border || bricks.contains(Brick<d>::of(z))) << z.transpose();
      }
  });
}

TYPED_TEST(DigitalSets, ComplementHoldsTheOtherPointsOfTheBox) {
  constexpr int d = TypeParam::value;
  RandomStream random{5};
  const LatticeBox<d> box{LatticePoint<d>::Constant(-9), LatticePoint<d>::Constant(12)};
  DigitalSet<d> set(box);
  for (int i = 0; i < 500; ++i) set.set(random_point<d>(box, random), true);
  const LatticeBox<d> wide = box.dilated(3);
  const DigitalSet<d> others = complement(set, wide);
  EXPECT_EQ(double(set.size() + others.size()), wide.volume());
  for_each_point(wide, [&](const LatticePoint<d>& z) { EXPECT_NE(set.contains(z), others.contains(z)); });
}

TEST(DigitalSetErrors, ADomainThatIsEmptyOrTooLarge) {
  EXPECT_THROW(DigitalSet<2>({{0, 0}, {-1, 5}}), ContractViolation);
  const int far = 1 << 29;
  EXPECT_THROW(DigitalSet<3>({{-far, -far, -far}, {far, far, far}}), InputError);
}

}  // namespace
}  // namespace gridstep
