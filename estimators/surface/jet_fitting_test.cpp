#include <gtest/gtest.h>

#include "estimators/catalogue.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {
namespace {

const EstimatorEntry& entry() {
  return find_estimator("jet-fitting");
}

TEST(JetFitting, SaysHowToGetItWhereItIsNotBuilt) {
  if (entry().not_built.empty()) return;
  try {
    (void)entry().variant<3>();
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "estimator 'jet-fitting' is not in this build: configure with -D GRIDSTEP_WITH_CGAL=ON (CGAL is "
        "under the GPL)");
  }
}

TEST(JetFitting, TellsABallFromATube) {
  if (!entry().not_built.empty()) return;  // a skipped test hides the runner's last line
  const double r = 30;
  const auto ball = ball_set<3>(r);
  const auto tube = set_where<3>({{-31, -31, -20}, {31, 31, 20}},
                                 [&](const auto& z) { return z[0] * z[0] + z[1] * z[1] <= r * r; });
  for (const auto* set : {&ball, &tube}) {
    std::vector<Surfel<3>> middle;
    for (const Surfel<3>& surfel : boundary(*set))
      if (std::abs(surfel.inner[2]) < 5) middle.push_back(surfel);
    const auto estimator = entry().variant<3>().make(*set, {});
    estimator->init({1}, {10});
    const Estimates estimates = estimator->eval(middle);
    for (std::size_t i = 0; i < middle.size(); ++i) {
      EXPECT_NEAR(estimates["k1"][i], 1 / r, 0.4 / r);
      EXPECT_NEAR(estimates["k2"][i], set == &ball ? 1 / r : 0, 0.4 / r);
    }
  }
}

}  // namespace
}  // namespace gridstep
