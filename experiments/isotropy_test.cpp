#include "experiments/isotropy.hpp"

#include <gtest/gtest.h>

namespace gridstep {
namespace {

/// One record a placement, with errors scaled by h.
std::vector<Record> records(bool rotated, const std::vector<double>& steps,
                            const std::vector<double>& errors) {
  std::vector<Record> result;
  for (const double h : steps)
    for (std::size_t shift = 0; shift < errors.size(); ++shift) {
      Record r;
      r.shape = "square";
      r.estimator = std::string("ii");
      r.rotated = rotated;
      r.k = 5;
      r.h = h;
      r.shift = int(shift);
      r.surfels = 10;
      const double error = h * errors[shift];
      r.errors = {{"kappa", {error, error, error, 10}}};
      result.push_back(r);
    }
  return result;
}

std::vector<Isotropy> isotropies(std::vector<Record> fixed, const std::vector<Record>& turned) {
  fixed.insert(fixed.end(), turned.begin(), turned.end());
  return isotropies_of(convergence_of(fixed, 1));
}

TEST(Isotropy, PutsRotationsBesideShifts) {
  const auto result =
      isotropies(records(false, {1, 0.5}, {3, 1, 2, 10}), records(true, {1, 0.5}, {4, 12, 9}));
  ASSERT_EQ(result.size(), 3u) << "one a norm";
  for (const Isotropy& entry : result) {
    EXPECT_EQ(entry.h, 0.5);
    EXPECT_FALSE(entry.rotated);
    EXPECT_EQ(entry.shifted.least, 0.5);
    EXPECT_EQ(entry.shifted.median, 1.25) << "between the two in the middle";
    EXPECT_EQ(entry.shifted.greatest, 5);
    EXPECT_EQ(entry.turned.least, 2);
    EXPECT_EQ(entry.turned.median, 4.5);
    EXPECT_EQ(entry.turned.greatest, 6);
    EXPECT_EQ(entry.within, 2u);
    EXPECT_EQ(entry.rotations, 3u);
  }
  const std::vector<std::string> row = isotropy_table(result).rows.at(0);
  EXPECT_EQ(row[12], "3.60x");
  EXPECT_EQ(row[13], "2 of 3");
}

TEST(Isotropy, IsThatOfTheFinestStepOfBoth) {
  const auto result = isotropies(records(false, {1, 0.5, 0.25}, {1, 2}), records(true, {1, 0.5, 0.125}, {3}));
  ASSERT_EQ(result.size(), 3u);
  EXPECT_EQ(result[0].h, 0.5);
  EXPECT_TRUE(isotropies(records(false, {1}, {1}), records(true, {0.5}, {1})).empty());
}

TEST(Isotropy, ComparesOnlyWhatDiffersInNothingElse) {
  auto turned = records(true, {1}, {1, 2});
  for (Record& r : turned) r.k = 4;
  EXPECT_TRUE(isotropies(records(false, {1}, {1, 2}), turned).empty());
  EXPECT_TRUE(isotropies(records(false, {1}, {1, 2}), {}).empty());
}

TEST(Isotropy, HasNoRatioToAnErrorOfZero) {
  EXPECT_EQ(isotropy_table(isotropies(records(false, {1}, {0}), records(true, {1}, {1}))).rows.at(0)[12],
            "-");
}

}  // namespace
}  // namespace gridstep
