#include "shapes/digital/brick.hpp"

#include <gtest/gtest.h>

#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

template <int d>
struct Dimension {
  static constexpr int value = d;
};
template <class>
class Bricks : public testing::Test {};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(Bricks, Dimensions);

template <int d>
Brick<d> random_brick(RandomStream& random) {
  Brick<d> brick;
  for (std::uint64_t& word : brick.words) word = random.bits();
  return brick;
}

TYPED_TEST(Bricks, BitsAndPointsCorrespond) {
  constexpr int d = TypeParam::value;
  for (int bit = 0; bit < Brick<d>::kBits; ++bit) EXPECT_EQ(Brick<d>::bit(Brick<d>::offset(bit)), bit);
  RandomStream random{1};
  for (int i = 0; i < 1000; ++i) {
    LatticePoint<d> z;
    for (int k = 0; k < d; ++k) z[k] = int(random.below(2000)) - 1000;
    const LatticePoint<d> b = Brick<d>::of(z);
    EXPECT_EQ(Brick<d>::origin(b) + Brick<d>::offset(Brick<d>::bit(z)), z);
  }
}

TYPED_TEST(Bricks, SetTestCountAndVisitAgree) {
  constexpr int d = TypeParam::value;
  RandomStream random{2};
  Brick<d> brick;
  EXPECT_EQ(brick.count(), 0);
  EXPECT_EQ(Brick<d>::full().count(), Brick<d>::kBits);
  std::vector<bool> expected(Brick<d>::kBits, false);
  for (int i = 0; i < 2000; ++i) {
    const int bit = int(random.below(Brick<d>::kBits));
    const bool value = random.below(2) == 0;
    brick.set(bit, value);
    expected[bit] = value;
  }
  std::vector<int> visited, wanted;
  for_each_bit(brick, [&](int bit) { visited.push_back(bit); });
  for (int bit = 0; bit < Brick<d>::kBits; ++bit) {
    EXPECT_EQ(brick.test(bit), expected[bit]);
    if (expected[bit]) wanted.push_back(bit);
  }
  EXPECT_EQ(visited, wanted);
  EXPECT_EQ(brick.count(), int(wanted.size()));
}

/// Bit by bit: the point one step along the axis, in the brick or in the next one.
template <int d>
Brick<d> shifted_slowly(const Brick<d>& brick, const Brick<d>& next, int axis, int direction) {
  Brick<d> result;
  for (int bit = 0; bit < Brick<d>::kBits; ++bit) {
    LatticePoint<d> z = Brick<d>::offset(bit);
    z[axis] += direction;
    const bool own = z[axis] >= 0 && z[axis] < Brick<d>::extent(axis);
    result.set(bit, (own ? brick : next).test(Brick<d>::bit(z)));
  }
  return result;
}

TYPED_TEST(Bricks, ShiftedIsTheNeighbourOfEveryBit) {
  constexpr int d = TypeParam::value;
  RandomStream random{3};
  for (int trial = 0; trial < 100; ++trial) {
    const Brick<d> brick = random_brick<d>(random), next = random_brick<d>(random);
    for (int axis = 0; axis < d; ++axis)
      for (const int direction : {-1, +1})
        ASSERT_EQ(shifted(brick, next, axis, direction), shifted_slowly(brick, next, axis, direction))
            << "axis " << axis << ", direction " << direction;
  }
}

}  // namespace
}  // namespace gridstep
