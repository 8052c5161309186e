#include "experiments/memory.hpp"

#include <gtest/gtest.h>

#include "estimators/catalogue.hpp"
#include "estimators/integral_invariant/bricks/ball_sums.hpp"
#include "shapes/analytic/catalogue.hpp"

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

template <int d>
SceneSettings<d> settings_of(double h, double noise) {
  SceneSettings<d> settings;
  settings.h = {h};
  settings.noise = noise;
  return settings;
}

template <int d = 3>
SetSize predicted(const std::string& spec, double h, double noise = 0) {
  return predicted_size<d>(spec, *make_shape<d>(spec), settings_of<d>(h, noise));
}

template <int d>
void expect_predicted(const std::string& spec, double h, double noise = 0) {
  const SetSize size = predicted<d>(spec, h, noise),
                real = size_of(make_scene<d>(*make_shape<d>(spec), settings_of<d>(h, noise)).set);
  EXPECT_GT(size.surfels, 0.5 * real.surfels) << spec;
  EXPECT_LT(size.surfels, 2 * real.surfels) << spec;
  EXPECT_GT(size.bytes, 0.2 * real.bytes) << spec;
  EXPECT_LT(size.bytes, 5 * real.bytes) << spec;
}

TEST(PredictedSize, IsThatOfTheSceneToWithinAFactorOfTwo) {
  expect_predicted<2>("flower", 0.001);
  expect_predicted<2>("disk", 0.5);
  expect_predicted<3>("sphere:radius=5", 0.02);
  expect_predicted<3>("sphere:radius=5", 0.05, 0.5);
  expect_predicted<3>("cube", 0.05);
  expect_predicted<3>("distel", 0.02);  // far smaller than its box
  expect_predicted<3>("torus:major=10,minor=0.005", 0.002);
}

TEST(PredictedSize, IsFoundWhateverTheSize) {
  const std::string ring = "torus:major=10,minor=0.0005,cz=0.0007";  // between the points of coarse steps
  EXPECT_GT(predicted(ring, 0.00001).surfels, 1e9);
  EXPECT_LT(predicted(ring, 0.00001).surfels, 1e10);
  EXPECT_NEAR(predicted("sphere:radius=1e120", 1e119).surfels / predicted("sphere:radius=10", 1).surfels, 1,
              1e-9);
  EXPECT_GT(predicted("sphere:radius=5", 0.01, 0.999).surfels,
            100 * predicted("sphere:radius=5", 0.01).surfels);
}

TEST(PredictedSize, NamesTheShapeAndTheStepThatIsAskedFor) {
  try {
    predicted("sphere:radius=1,cx=1e12", 0.001);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "sphere:radius=1,cx=1e12: h = 0.001: the shape spans more than 2^29 cells");
  }
}

}  // namespace
}  // namespace gridstep
