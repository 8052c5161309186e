#include <gtest/gtest.h>

#include <cmath>

#include "estimators/contour/tangential_cover.hpp"
#include "estimators/contour/testing_contours.hpp"

namespace gridstep {
namespace {

class Tangent : public testing::TestWithParam<const char*> {
 protected:
  std::vector<RealPoint<2>> tangents(const std::vector<Surfel<2>>& linels) const {
    const Estimates estimates = estimate(GetParam(), linels, 0.1);
    std::vector<RealPoint<2>> result;
    for (std::size_t i = 0; i < linels.size(); ++i)
      result.emplace_back(estimates["tangent_x"][i], estimates["tangent_y"][i]);
    return result;
  }
};

TEST_P(Tangent, IsAUnitVectorNearTheDirectionOfTheLinel) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto linels = random_linels(seed, 30);
    const auto t = tangents(linels);
    ASSERT_EQ(t.size(), linels.size());
    for (std::size_t i = 0; i < t.size(); ++i) {
      EXPECT_NEAR(t[i].norm(), 1, 1e-15);
      const LatticePoint<2> step = end_pointel(linels[i]) - start_pointel(linels[i]);
      EXPECT_GT(t[i].dot(step.cast<double>()), 0);
    }
  }
}

// A large octagon of sides with directions (+-q, +-p) and (+-p, +-q). Inside a side, where no other segment
// goes, the tangent is its direction.
TEST_P(Tangent, IsExactInsideSides) {
  for (const auto& [p, q] : {std::pair{1, 1}, std::pair{1, 3}, std::pair{2, 5}}) {
    const auto linels =
        connected_boundary(set_where<2>({LatticePoint<2>{-120, -120}, LatticePoint<2>{120, 120}},
                                        [p = p, q = q](const LatticePoint<2>& z) {
                                          const int x = std::abs(z[0]), y = std::abs(z[1]);
                                          return p * x + q * y <= 100 * q && q * x + p * y <= 100 * q;
                                        }))
            .surfels;
    const TangentialCover cover(closed_contours(linels)[0]);
    const auto ranges = cover.segments_of_linels();
    const auto t = tangents(linels);
    int inside = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (ranges[i].end - ranges[i].begin != 1) continue;
      const DigitalLine line = cover[ranges[i].begin].line;
      const auto a = std::abs(line.a), b = std::abs(line.b);
      if (!((a == p && b == q) || (a == q && b == p))) continue;
      ++inside;
      const RealPoint<2> direction = RealPoint<2>(double(line.b), double(line.a)).normalized();
      EXPECT_LT((t[i] - direction).norm(), 1e-15);
      const RealPoint<2> left(-direction[1], direction[0]);  // where the set is
      EXPECT_LT(left.dot(linels[i].inner.cast<double>()), 0);
    }
    EXPECT_GT(inside, int(linels.size()) / 4) << p << '/' << q;
  }
}

TEST_P(Tangent, DoesNotDependOnTheFirstLinelAndTurnsWithTheAxes) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto linels = random_linels(seed, 30);
    auto expected = tangents(linels);
    std::vector<Surfel<2>> turns;
    for (const Surfel<2>& linel : linels) turns.push_back(turned(linel));
    const auto after = tangents(turns);
    for (std::size_t i = 0; i < after.size(); ++i)
      EXPECT_EQ(after[i], (RealPoint<2>{-expected[i][1], expected[i][0]}));
    const auto shift = std::ptrdiff_t(linels.size() / 3);
    std::rotate(linels.begin(), linels.begin() + shift, linels.end());
    std::rotate(expected.begin(), expected.begin() + shift, expected.end());
    EXPECT_EQ(tangents(linels), expected);
  }
}

// The mean error of the tangent of a convex shape is O(h^1/3).
TEST_P(Tangent, ConvergesOnTheMeanOnADisk) {
  std::vector<double> steps, errors;
  for (const double r : {10.3, 20.6, 41.2, 82.4, 164.8, 329.6}) {
    const auto linels = connected_boundary(ball_set<2>(r)).surfels;
    const auto t = tangents(linels);
    double sum = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
      const RealPoint<2> normal = centre(linels[i], 1).normalized();
      sum += std::abs(std::asin(t[i].dot(normal)));
      EXPECT_GT(normal[0] * t[i][1] - normal[1] * t[i][0], 0.7);  // counterclockwise
    }
    steps.push_back(1 / r);
    errors.push_back(sum / double(t.size()));
  }
  EXPECT_GT(log_log_slope(steps, errors), 1.0 / 3.0);
  EXPECT_LT(errors.back(), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Both, Tangent, testing::Values("mst", "lambda-mst"),
                         [](const auto& name) { return name.index == 0 ? "Mst" : "LambdaMst"; });

}  // namespace
}  // namespace gridstep
