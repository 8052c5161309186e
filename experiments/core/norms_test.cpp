#include "experiments/core/norms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "shapes/base/contracts.hpp"
#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

TEST(ErrorNorms, AConstantErrorGivesThatConstantForEveryCount) {
  for (const std::size_t n : {1u, 3u, 100u, 10007u, 10'000'000u}) {
    const ErrorNorms norms = error_norms(std::vector<double>(n, -0.1));
    EXPECT_EQ(norms.sup, 0.1);
    EXPECT_EQ(norms.rms, 0.1) << n;
    EXPECT_EQ(norms.mean, 0.1) << n;
    EXPECT_EQ(norms.count, n);
  }
}

TEST(ErrorNorms, FollowTheirDefinitions) {
  const ErrorNorms norms = error_norms(std::vector<double>{3, -4, 0, 0});
  EXPECT_DOUBLE_EQ(norms.sup, 4);
  EXPECT_DOUBLE_EQ(norms.rms, 2.5);
  EXPECT_DOUBLE_EQ(norms.mean, 1.75);
}

TEST(ErrorNorms, AreOrderedScaleAndIgnoreSigns) {
  RandomStream random({1});
  std::vector<double> errors(1000), scaled;
  for (double& e : errors) e = random.uniform() - 0.5;
  for (const double e : errors) scaled.push_back(-8 * e);
  const ErrorNorms a = error_norms(errors), b = error_norms(scaled);
  EXPECT_LT(a.mean, a.rms);
  EXPECT_LT(a.rms, a.sup);
  EXPECT_DOUBLE_EQ(b.sup, 8 * a.sup);
  EXPECT_DOUBLE_EQ(b.rms, 8 * a.rms);
  EXPECT_DOUBLE_EQ(b.mean, 8 * a.mean);
}

TEST(ErrorNorms, RepeatingTheErrorsChangesNoNorm) {
  const std::vector<double> once{0.5, -0.25, 0.125};
  std::vector<double> often;
  for (int i = 0; i < 1000; ++i) often.insert(often.end(), once.begin(), once.end());
  EXPECT_NEAR(error_norms(often).rms, error_norms(once).rms, 1e-15);
  EXPECT_NEAR(error_norms(often).mean, error_norms(once).mean, 1e-15);
}

TEST(ErrorNorms, DoNotDependOnTheOrderOfManyErrors) {
  std::vector<double> errors(10'000'000, 1e-5);
  errors.front() = 1;  // first: a plain sum then drops digits of every later term
  const ErrorNorms first = error_norms(errors);
  std::swap(errors.front(), errors.back());
  const ErrorNorms last = error_norms(errors);
  EXPECT_DOUBLE_EQ(first.rms, last.rms);
  EXPECT_DOUBLE_EQ(first.mean, last.mean);
  EXPECT_NEAR(first.mean, (1 + 1e-5 * 9'999'999) / 1e7, 1e-19);
}

TEST(ErrorNorms, NeitherOverflowNorVanish) {
  EXPECT_DOUBLE_EQ(error_norms(std::vector<double>{1e300, 1e300}).rms, 1e300);
  EXPECT_DOUBLE_EQ(error_norms(std::vector<double>{1e-300, 1e-300}).rms, 1e-300);
  EXPECT_EQ(error_norms(std::vector<double>{0, 0}).rms, 0);
}

TEST(ErrorNorms, RefuseNothingAndNonFiniteErrors) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(error_norms({}), ContractViolation);
  EXPECT_THROW(error_norms(std::vector<double>{1, nan, 2}), ContractViolation);
  EXPECT_THROW(error_norms(std::vector<double>{nan}), ContractViolation);
  EXPECT_THROW(error_norms(std::vector<double>{1, -inf}), ContractViolation);
}

}  // namespace
}  // namespace gridstep
