#include <gtest/gtest.h>

#include "shapes/analytic/testing_catalogue.hpp"

namespace gridstep {
namespace {

TEST(Heart, HasNoTruthNearItsSingularPoints) {
  const double r = 9, away = 4;
  const auto whole = make_shape<3>("heart:radius=9"), shape = make_shape<3>("heart:radius=9,away=4");
  auto settings = random_settings<3>(0.5, 3);
  int left_out = 0, known = 0;
  for (const Surfel<3>& surfel : make_scene(*shape, settings).surfels) {
    const RealPoint<3> query = settings.placement.to_shape(centre(surfel, settings.h.value), settings.h);
    const EuclideanLength within{0.26};
    const auto all = whole->project(query, within), some = shape->project(query, within);
    if (!all) {
      EXPECT_FALSE(some);
      continue;
    }
    const double distance = std::min((all->position - RealPoint<3>(0, 0, r)).norm(),
                                     (all->position + RealPoint<3>(0, 0, r)).norm());
    EXPECT_EQ(some.has_value(), distance >= away) << all->position.transpose();
    ++(some ? known : left_out);
    if (some) {
      EXPECT_EQ(some->position, all->position);
    }
  }
  EXPECT_GT(left_out, 100);
  EXPECT_GT(known, 5 * left_out);
}

TEST(Heart, IsSingularAtTheTipWhateverIsLeftOut) {
  EXPECT_THROW(make_shape<3>("heart:radius=9,away=1")->truth({0, 0, -9.1}, {0.2}), InputError);
  EXPECT_THROW(make_shape<3>("heart")->truth({0, 0, -1.01}, {0.02}), InputError);
  EXPECT_THROW(make_shape<3>("heart:away=-1"), InputError);
}

}  // namespace
}  // namespace gridstep
