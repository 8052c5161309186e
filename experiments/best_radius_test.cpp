#include "experiments/best_radius.hpp"

#include <gtest/gtest.h>

namespace gridstep {
namespace {

/// sup errors h (k - 4)^2 + 1, with noise of the shifts that has no mean.
std::vector<RadiusScan> scans(const std::vector<double>& ks) {
  std::vector<Record> records;
  for (const double k : ks)
    for (const double h : {1.0, 0.5, 0.25})
      for (const int shift : {0, 1}) {
        Record r;
        r.shape = "disk";
        r.estimator = std::string("ii");
        r.k = k;
        r.h = h;
        r.shift = shift;
        r.surfels = 10;
        const double error = h * (k - 4) * (k - 4) + 1 + (shift ? 0.01 : -0.01);
        r.errors = {{"kappa", {error, error, error, 10}}};
        records.push_back(r);
      }
  return radius_scans_of(convergence_of(records, 1));
}

TEST(BestRadius, IsThatOfTheLeastMeanErrorAtTheCoarsestAndTheFinestStep) {
  const auto result = scans({6, 2, 3.5});
  ASSERT_EQ(result.size(), 6u) << "two steps, three norms";
  EXPECT_EQ(result[0].h, 1);
  EXPECT_EQ(result[1].h, 0.25);
  for (const RadiusScan& scan : result) {
    EXPECT_EQ(scan.k, 3.5);
    EXPECT_NEAR(scan.least_error, 0.25 * scan.h + 1, 1e-12);
    ASSERT_EQ(scan.errors.size(), 3u);
    EXPECT_EQ(scan.errors[0].first, 2) << "by k";
  }
}

TEST(BestRadius, IsMarkedAtEitherEnd) {
  const auto cell = [](const std::vector<double>& ks) {
    return best_radius_table(scans(ks)).rows.front()[5];
  };
  EXPECT_EQ(cell({2, 4, 6}), "4");
  EXPECT_EQ(cell({4, 5, 6}), "<4");
  EXPECT_EQ(cell({2, 3}), ">3");
}

TEST(BestRadius, NeedsSeveralRadii) {
  EXPECT_TRUE(scans({3}).empty());
}

}  // namespace
}  // namespace gridstep
