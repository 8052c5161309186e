#include "experiments/distribution.hpp"

#include <gtest/gtest.h>

#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

TEST(Distribution, OfEvenlySpacedValuesIsTheirPlace) {
  std::vector<double> values;
  for (int i = 200; i >= 0; --i) values.push_back(2.0 * i);
  const Distribution distribution = distribution_of(values);
  for (std::size_t i = 0; i < distribution.quantiles.size(); ++i)
    EXPECT_DOUBLE_EQ(distribution.quantiles[i], 400 * Distribution::kProbabilities[i]);
  EXPECT_DOUBLE_EQ(distribution.mean, 200);
}

TEST(Distribution, InterpolatesBetweenTwoValues) {
  const Distribution distribution = distribution_of({3, 1});
  for (std::size_t i = 0; i < distribution.quantiles.size(); ++i)
    EXPECT_DOUBLE_EQ(distribution.quantiles[i], 1 + 2 * Distribution::kProbabilities[i]);
}

TEST(Distribution, OfOneValueIsThatValue) {
  for (const double q : distribution_of({-2.5}).quantiles) EXPECT_EQ(q, -2.5);
  EXPECT_THROW(distribution_of({}), ContractViolation);
}

}  // namespace
}  // namespace gridstep
