#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "shapes/analytic/testing_catalogue.hpp"

namespace gridstep {
namespace {

TEST(Star, IsLeftOnceByEveryRayFromItsCentre) {
  RandomStream random{1};
  for (const int seed : {0, 1, 2, 3, 12345})
    for (const double roughness : {0.0, 0.5, 1.0}) {
      const auto shape = make_shape<3>(fmt::format("star:seed={},roughness={}", seed, roughness));
      for (int ray = 0; ray < 100; ++ray) {
        const RealPoint<3> u = random_rotation<3>(random).col(0);
        bool inside = true;
        for (double t = 0; t < 20; t += 0.05) {
          const bool now = shape->contains(t * u);
          EXPECT_FALSE(now && !inside) << seed << " " << roughness << " " << t;
          inside = now;
        }
        EXPECT_FALSE(inside);
      }
    }
}

TEST(Star, IsASphereWithoutRoughness) {
  const auto shape = make_shape<3>("star:radius=4,roughness=0");
  const auto foot = shape->truth({1, -2, 3.2}, {1});
  EXPECT_NEAR(foot.position.norm(), 4, 1e-12);
  EXPECT_NEAR(foot.curvature[0], 0.25, 1e-12);
  EXPECT_NEAR(foot.curvature[1], 0.25, 1e-12);
}

TEST(Star, FollowsFromItsSeed) {
  std::set<double> sizes;
  for (const int seed : {0, 1, 2, 3}) {
    const std::string text = fmt::format("star:seed={}", seed);
    EXPECT_EQ(make_shape<3>(text)->size(), make_shape<3>(text)->size());
    sizes.insert(make_shape<3>(text)->size());
  }
  EXPECT_EQ(sizes.size(), 4u);
  EXPECT_THROW(make_shape<3>("star:seed=-1"), InputError);
  EXPECT_THROW(make_shape<3>("star:seed=0.5"), InputError);
  EXPECT_THROW(make_shape<3>("star:roughness=1.1"), InputError);
}

}  // namespace
}  // namespace gridstep
