#include "shapes/digital/gauss_digitize.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes/analytic/testing_catalogue.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {
namespace {

class Digitization : public testing::TestWithParam<std::string> {
 protected:
  /// Calls check(shape) with the shape in its own dimension.
  template <class Check>
  static void with_shape(Check check) {
    std::visit([&](const auto& shape) { check(*shape); }, make_shape(ShapeSpec{GetParam(), {}}));
  }
};
INSTANTIATE_TEST_SUITE_P(Shapes, Digitization, testing::ValuesIn(all_names()), test_name);

/// The number of points of the box at which the set is not what the region says.
template <int d>
std::int64_t differences(const DigitalSet<d>& set, const Region<d>& region, GridStep h,
                         const LatticeBox<d>& box) {
  std::int64_t result = 0;
  std::vector<LatticePoint<d>> lattice;
  std::vector<RealPoint<d>> points;
  const auto compare = [&] {
    const std::uint64_t inside = region.inside(points);
    for (std::size_t i = 0; i < points.size(); ++i) result += ((inside >> i) & 1) != set.contains(lattice[i]);
    lattice.clear();
    points.clear();
  };
  for_each_point(box, [&](const LatticePoint<d>& z) {
    lattice.push_back(z);
    points.push_back(h.value * z.template cast<double>());
    if (points.size() == 64) compare();
  });
  compare();
  return result;
}

/// The points around the middle of the shape, all of them but for the spikes of distel.
template <int d>
LatticeBox<d> compared_box(const Region<d>& region, double feature, GridStep h) {
  const int reach = int(std::ceil(2.1 * feature / h.value));
  return digital_bounds<d>(region, h).intersection(
      {LatticePoint<d>::Constant(-reach), LatticePoint<d>::Constant(reach)});
}

TEST_P(Digitization, EqualsSamplingPointByPoint) {
  with_shape([]<int d>(const Shape<d>& shape) {
    std::uint64_t seed = 0;
    for (const double steps : {1.5, 4.0, 13.0, d == 2 ? 90.0 : 30.0, d == 2 ? 400.0 : 45.0})
      for (const bool rotated : {false, true}) {
        auto settings = random_settings<d>(feature(shape) / steps, ++seed);
        if (!rotated) settings.placement.rotation.setIdentity();
        const PlacedRegion<d> region(shape, settings.placement, settings.h);
        const DigitalSet<d> set = gauss_digitize<d>(region, settings.h);
        EXPECT_EQ(
            differences<d>(set, region, settings.h, compared_box<d>(region, feature(shape), settings.h)), 0)
            << "h = " << settings.h.value << ", seed " << seed;
      }
  });
}

/// Where lattice points lie on flat faces, at corners and at singular points, rounding decides.
TEST_P(Digitization, EqualsSamplingWherePointsLieOnTheBoundary) {
  with_shape([]<int d>(const Shape<d>& shape) {
    const GridStep h{std::exp2(std::round(std::log2(feature(shape) / 20)))};
    const DigitalSet<d> set = gauss_digitize<d>(shape, h);
    EXPECT_EQ(differences<d>(set, shape, h, compared_box<d>(shape, feature(shape), h)), 0);
  });
}

/// A placed region is that of Placement::to_shape(), bit for bit.
TEST_P(Digitization, PlacesPointsAsThePlacementDoes) {
  with_shape([]<int d>(const Shape<d>& shape) {
    RandomStream random{8};
    for (const bool rotated : {false, true}) {
      auto settings = random_settings<d>(feature(shape) / 7, 9);
      if (!rotated) settings.placement.rotation.setIdentity();
      const PlacedRegion<d> region(shape, settings.placement, settings.h);
      const auto surfels = make_scene(shape, settings).surfels;
      for (int i = 0; i < 300; ++i) {
        const auto& surfel = surfels[random.below(std::uint32_t(surfels.size()))];
        RealPoint<d> in = settings.h.value * surfel.inner.template cast<double>();
        RealPoint<d> out = settings.h.value * surfel.outer().template cast<double>();
        for (int halving = 0; halving < 60; ++halving) {  // to where the last bit counts
          const RealPoint<d> middle = (in + out) / 2;
          const bool inside = region.contains(middle);
          ASSERT_EQ(inside, shape.contains(settings.placement.to_shape(middle, settings.h)));
          (inside ? in : out) = middle;
        }
      }
    }
  });
}

/// Calls to the region for each surfel, where the digital set has about `aim` surfels.
template <int d>
double calls_per_surfel(const Shape<d>& shape, double aim, bool rotated) {
  double h = feature(shape) / 10;
  while (true) {
    auto settings = random_settings<d>(h, 7);
    if (!rotated) settings.placement.rotation.setIdentity();
    const PlacedRegion<d> region(shape, settings.placement, settings.h);
    DigitizationWork work;
    const double surfels = double(boundary(gauss_digitize<d>(region, settings.h, &work)).size());
    if (surfels > aim) return double(work.points + work.boxes) / surfels;
    h *= std::clamp(0.97 * std::pow(surfels / aim, 1.0 / (d - 1)), 0.3, 0.9);
  }
}

TEST_P(Digitization, CallsTheRegionAFewTimesASurfel) {
  with_shape([]<int d>(const Shape<d>& shape) {
    for (const bool rotated : {false, true}) {
      const double aim = d == 2 ? 5000 : 50000;
      const double calls = calls_per_surfel(shape, aim, rotated);
      EXPECT_LE(calls, 12) << (rotated ? "rotated" : "shifted");
      // So the calls grow no faster than the surfels do, as h^-(d-1). At fine steps a bound is used for boxes
      // so large that its slab of error leaves about one point a surfel open.
      const double finer = calls_per_surfel(shape, (d == 2 ? 8 : 4) * aim, rotated);
      EXPECT_LE(finer, 1.25 * std::max(calls, 1.0)) << (rotated ? "rotated" : "shifted");
    }
  });
}

/// The quadratic function decides as it says, right up to its error: at points of boxes of all sizes near the
/// boundary.
TEST_P(Digitization, BoundsNeverContradictTheRegion) {
  with_shape([]<int d>(const Shape<d>& shape) {
    const auto settings = random_settings<d>(feature(shape) / 30, 11);
    const PlacedRegion<d> region(shape, settings.placement, settings.h);
    const auto surfels = make_scene(shape, settings).surfels;
    RandomStream random{12};
    std::int64_t decided = 0, wrong = 0;
    for (int i = 0; i < 4000; ++i) {
      const auto& surfel = surfels[random.below(std::uint32_t(surfels.size()))];
      const double scale = settings.h.value * std::exp2(4 - 44 * random.uniform());
      RealPoint<d> in = settings.h.value * surfel.inner.template cast<double>();
      RealPoint<d> out = settings.h.value * surfel.outer().template cast<double>();
      for (int halving = 0; halving < 50; ++halving) {
        const RealPoint<d> middle = (in + out) / 2;
        (region.contains(middle) ? in : out) = middle;
      }
      RealPoint<d> low, high;
      for (int k = 0; k < d; ++k) {
        low[k] = in[k] - scale * random.uniform();
        high[k] = in[k] + scale * random.uniform();
      }
      const RealBox<d> box(low, high);
      const QuadraticBound<d> bound = region.bound(box);
      for (int sample = 0; sample < 40; ++sample) {
        const RealPoint<d> p = random_point(box, random).cwiseMax(low).cwiseMin(high);
        const double level = bound(p);
        if (!(std::abs(level) > bound.error + bound.rounding(greatest_coordinate(box)))) continue;
        ++decided;
        wrong += region.contains(p) != (level < 0);
      }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(decided, 20000) << "bounds of no use";
  });
}

TEST(DigitizationErrors, AStepThatIsNotOneOrTooFine) {
  const auto disk = make_shape<2>("disk");
  EXPECT_THROW(gauss_digitize<2>(*disk, {0}), ContractViolation);
  EXPECT_THROW(gauss_digitize<2>(*disk, {1e-9}), InputError);
}

}  // namespace
}  // namespace gridstep
