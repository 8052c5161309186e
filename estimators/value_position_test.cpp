#include "estimators/value_position.hpp"

#include <gtest/gtest.h>

#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {
namespace {

TEST(ValuePoints, AreTheCentresOfSurfels) {
  const auto surfels = boundary(ball_set<3>(3));
  const auto points = value_points<3>(ValuePosition::surfel_centre, surfels, {0.5});
  ASSERT_EQ(points.size(), surfels.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], centre(surfels[i], 0.5));
  EXPECT_THROW(value_points<3>(ValuePosition::start_pointel, surfels, {0.5}), ContractViolation);
}

TEST(ValuePoints, AreTheStartsOfLinels) {
  const auto linels = connected_boundary(ball_set<2>(6)).surfels;
  const auto points = value_points<2>(ValuePosition::start_pointel, linels, {0.5});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RealPoint<2> next = points[(i + 1) % points.size()];
    EXPECT_EQ((points[i] + next) / 2, centre(linels[i], 0.5)) << "a linel is centred between its ends";
    EXPECT_EQ((next - points[i]).norm(), 0.5);
  }
}

TEST(FarthestFromBoundary, HoldsForTheEndsOfLinelsToo) {
  EXPECT_NEAR(farthest_from_boundary(ValuePosition::surfel_centre, {0.2}).value, 0.1, 1e-9);
  EXPECT_NEAR(farthest_from_boundary(ValuePosition::start_pointel, {0.2}).value, 0.2, 1e-9);
}

}  // namespace
}  // namespace gridstep
