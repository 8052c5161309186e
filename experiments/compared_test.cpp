#include "experiments/compared.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gridstep {
namespace {

TEST(ComparedQuantities, AreScalarsAndTheVectorsThatTheTruthHas) {
  std::vector<std::string> names;
  for (const Compared& compared : compared_quantities("ii-covariance", 3)) names.push_back(compared.name);
  EXPECT_EQ(names, (std::vector<std::string>{"mean", "gaussian", "k1", "k2", "normal"}));
  const Compared normal = compared_quantities("ii-covariance", 3).back();
  EXPECT_EQ(normal.columns, (std::vector<std::string>{"normal_x", "normal_y", "normal_z"}));
  EXPECT_EQ(compared_quantities("ii", 2).front().proven_rate, 1.0 / 3.0);
  EXPECT_TRUE(compared_quantities("ii-covariance", 2).empty());
}

Truth truth(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns) {
  Truth result;
  result.quantities = names;
  result.columns = columns;
  result.known = {1, 0, 1};
  return result;
}

TEST(ErrorsOf, ScalarsAreEstimateMinusTruthWhereKnown) {
  const Truth exact = truth({"mean", "kappa"}, {{9, 9, 9}, {1, 0, -2}});
  const auto errors = errors_of({"kappa", {"kappa"}, {}}, {{"kappa"}, {{1.5, 7, -3}}}, exact);
  EXPECT_EQ(errors, (std::vector<double>{0.5, 0, -1}));
  EXPECT_EQ(known_only(errors, exact), (std::vector<double>{0.5, -1}));
}

TEST(ErrorsOf, VectorsAreComparedByAngle) {
  const Compared tangent{"tangent", {"tangent_x", "tangent_y"}, {}};
  for (const double angle : {0.0, 1e-12, 0.3, 2.0, M_PI}) {
    const Truth exact = truth({"tangent_x", "tangent_y"}, {{1, 0, 0}, {0, 0, 1}});
    const Estimates estimates{{"tangent_x", "tangent_y"},
                              {{std::cos(angle), 5, std::sin(angle)}, {std::sin(angle), 5, std::cos(angle)}}};
    const auto errors = errors_of(tangent, estimates, exact);
    EXPECT_NEAR(errors[0], angle, 1e-15 + 1e-12 * angle);
    EXPECT_EQ(errors[1], 0);
    EXPECT_NEAR(errors[2], angle, 1e-15 + 1e-12 * angle);
  }
}

}  // namespace
}  // namespace gridstep
