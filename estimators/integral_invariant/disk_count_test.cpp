#include "estimators/integral_invariant/disk_count.hpp"

#include <gtest/gtest.h>

#include "estimators/integral_invariant/kernel.hpp"
#include "estimators/testing_sets.hpp"

namespace gridstep {
namespace {

const double kRadii[] = {1, 1.2, 1.5, 2, 5, 0.3 / 0.1, 7.7, 25, 63.9, 100};

TEST(DiskRows, HoldThePointsOfTheBallKernel) {
  for (const double r : kRadii) {
    const auto kernel = ball_kernel<2>({r});
    const DiskRows disk({r});
    std::int64_t points = 0;
    for (int y = -disk.reach(); y <= disk.reach(); ++y) points += 2 * disk.half_width(y) + 1;
    EXPECT_EQ(points, std::int64_t(kernel.size())) << r;
    for (const LatticePoint<2>& z : kernel.offsets) {
      ASSERT_LE(std::abs(z[1]), disk.reach()) << r;
      ASSERT_LE(std::abs(z[0]), disk.half_width(z[1])) << r;
    }
  }
  EXPECT_THROW(DiskRows({0.99}), InputError);
  EXPECT_THROW(DiskRows({std::nan("")}), InputError);
  EXPECT_THROW(DiskRows({1e9}), InputError);
}

TEST(RowRuns, CountDisksAsTheKernelDoes) {
  RandomStream random({5});
  for (const double density : {0.1, 0.5, 0.97, 1.0}) {
    const auto set = random_set<2>({LatticePoint<2>{-70, -41}, LatticePoint<2>{150, 77}}, density, 4);
    const RowRuns rows(set);
    for (const double r : kRadii) {
      const auto kernel = ball_kernel<2>({r});
      const DiskRows disk({r});
      for (int i = 0; i < 8; ++i) {
        const LatticePoint<2> z{int(random.below(300)) - 110, int(random.below(200)) - 90};
        std::int64_t expected = 0;
        for (const LatticePoint<2>& offset : kernel.offsets) expected += set.contains(z + offset);
        ASSERT_EQ(rows.count(z, disk), expected) << r << " at " << z.transpose();
      }
    }
  }
}

TEST(RowRuns, CountPartsOfRows) {
  DigitalSet<2> set({LatticePoint<2>{-2, -2}, LatticePoint<2>{9, 5}});
  for (const int x : {-2, -1, 3, 4, 5, 9}) set.set({x, 1}, true);
  set.set({0, 4}, true);
  const RowRuns rows(set);
  EXPECT_EQ(rows.count(1, -100, 100), 6);
  EXPECT_EQ(rows.count(1, -1, 4), 3);
  EXPECT_EQ(rows.count(1, 0, 2), 0);
  EXPECT_EQ(rows.count(1, 4, 3), 0);
  EXPECT_EQ(rows.count(1, 9, 9), 1);
  EXPECT_EQ(rows.count(2, -5, 5), 0) << "an empty row between others";
  EXPECT_EQ(rows.count(4, -5, 5), 1);
  EXPECT_EQ(rows.count(5, -5, 5) + rows.count(0, -5, 5) + rows.count(-90, -5, 5), 0);
  EXPECT_EQ(RowRuns(DigitalSet<2>({{0, 0}, {1, 1}})).count(0, -9, 9), 0);
}

}  // namespace
}  // namespace gridstep
