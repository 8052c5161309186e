#include "experiments/memory.hpp"

#include <gtest/gtest.h>

#include "estimators/catalogue.hpp"
#include "estimators/integral_invariant/bricks/ball_sums.hpp"

namespace gridstep {
namespace {

/// Bytes that the tables of one ball take of those predicted for an estimator.
template <int d, class Sum>
double part_of_prediction(const std::string& estimator, double radius) {
  const double predicted =
      predicted_table_memory<d>(find_estimator(estimator).variant<d>(), {radius}, Evaluation::bricks, 1);
  return double(bricks::BallSums<d, Sum>({radius}, -1).memory()) / predicted;
}

TEST(PredictedTableMemory, IsEnoughForBricksAndNotFarTooMuch) {
  for (const double radius : {10.0, 40.0, 160.0, 400.0}) {
    const double counts = part_of_prediction<3, PlainSum<3, std::int64_t>>("ii", radius),
                 moments = part_of_prediction<3, MomentSums<3, std::int64_t>>("ii-covariance", radius);
    EXPECT_LE(counts, 1) << radius;
    EXPECT_LE(moments, 1) << radius;
    EXPECT_GT(counts, 0.4) << radius;
    EXPECT_GT(moments, 0.4) << radius;
  }
  for (const double radius : {20.0, 171.0, 2000.0}) {
    const double counts = part_of_prediction<2, PlainSum<2, std::int64_t>>("ii", radius);
    EXPECT_LE(counts, 1) << radius;
  }
}

}  // namespace
}  // namespace gridstep
