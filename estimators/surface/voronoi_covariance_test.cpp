#include "estimators/surface/voronoi_covariance.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "estimators/testing_sets.hpp"

namespace gridstep {
namespace {

/// By looking at every site from every point.
std::vector<Eigen::Matrix3d> by_hand(const std::vector<LatticePoint<3>>& sites, double R) {
  std::vector<Eigen::Matrix3d> result(sites.size(), Eigen::Matrix3d::Zero());
  LatticeBox<3> box{sites[0], sites[0]};
  for (const LatticePoint<3>& site : sites) box = {box.lo.cwiseMin(site), box.hi.cwiseMax(site)};
  for_each_point(box.dilated(int(R) + 1), [&](const LatticePoint<3>& p) {
    int least = std::numeric_limits<int>::max();
    for (const LatticePoint<3>& site : sites) least = std::min(least, (p - site).squaredNorm());
    if (least > R * R) return;
    double share = 0;
    for (const LatticePoint<3>& site : sites) share += (p - site).squaredNorm() == least;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Eigen::Vector3d v = (p - sites[i]).cast<double>();
      if ((p - sites[i]).squaredNorm() == least) result[i] += v * v.transpose() / share;
    }
  });
  return result;
}

TEST(VoronoiCovariance, SharesOutThePointsNearEachSite) {
  std::vector<LatticePoint<3>> sites;
  // Across zero and across blocks.
  for_each_point_of(random_set<3>({{55, -6, -5}, {73, 7, 6}}, 0.03, 51),
                    [&](const LatticePoint<3>& z) { sites.push_back(z); });
  ASSERT_GT(sites.size(), 30u);
  for (const double R : {1.0, 3.0, 5.4}) {
    const auto covariances = voronoi_covariances(sites, {R}), expected = by_hand(sites, R);
    for (std::size_t i = 0; i < sites.size(); ++i)
      EXPECT_NEAR((covariances[i] - expected[i]).norm(), 0, 1e-11) << R << " " << sites[i].transpose();
  }
}

TEST(VoronoiCovariance, OfASiteIsThatOfItsSurroundings) {
  // Sites farther than 2R away change nothing, to the last bit.
  std::vector<LatticePoint<3>> sites;
  for_each_point_of(random_set<3>({{-20, -8, -8}, {20, 8, 8}}, 0.05, 52),
                    [&](const LatticePoint<3>& z) { sites.push_back(z); });
  const double R = 4.2;
  std::vector<LatticePoint<3>> near;
  for (const LatticePoint<3>& site : sites)
    if ((site - sites[7]).cast<double>().norm() <= 2 * R) near.push_back(site);
  ASSERT_LT(near.size(), sites.size());
  const auto at = std::size_t(std::find(near.begin(), near.end(), sites[7]) - near.begin());
  EXPECT_EQ(voronoi_covariances(near, {R})[at], voronoi_covariances(sites, {R})[7]);
}

}  // namespace
}  // namespace gridstep
