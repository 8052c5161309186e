#include "shapes/digital/gauss_digitize.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes/analytic/convex_polytope.hpp"
#include "shapes/analytic/implicit_shape.hpp"
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

struct FineDigitization {
  double calls;       // to the region for each surfel
  std::size_t wrong;  // surfels whose spels are not on its two sides
};

/// Where the digital set has about `aim` surfels.
template <int d>
FineDigitization digitize_finely(const Shape<d>& shape, double aim, bool rotated) {
  double h = feature(shape) / 10;
  while (true) {
    auto settings = random_settings<d>(h, 7);
    if (!rotated) settings.placement.rotation.setIdentity();
    const PlacedRegion<d> region(shape, settings.placement, settings.h);
    DigitizationWork work;
    const auto surfels = boundary(gauss_digitize<d>(region, settings.h, &work));
    const auto count = double(surfels.size());
    if (count > aim) {
      const auto contains = [&](const LatticePoint<d>& z) {
        return region.contains(settings.h.value * z.template cast<double>());
      };
      const auto wrong = std::count_if(surfels.begin(), surfels.end(), [&](const Surfel<d>& surfel) {
        return !contains(surfel.inner) || contains(surfel.outer());
      });
      return {double(work.points + work.boxes) / count, std::size_t(wrong)};
    }
    h *= std::clamp(0.97 * std::pow(count / aim, 1.0 / (d - 1)), 0.3, 0.9);
  }
}

TEST_P(Digitization, CallsTheRegionAFewTimesASurfel) {
  with_shape([]<int d>(const Shape<d>& shape) {
    for (const bool rotated : {false, true}) {
      const double aim = d == 2 ? 5000 : 50000;
      const FineDigitization coarse = digitize_finely(shape, aim, rotated);
      EXPECT_LE(coarse.calls, 4) << (rotated ? "rotated" : "shifted");
      // The calls grow no faster than the surfels do, as h^-(d-1): bounds of many bricks leave few points open.
      const FineDigitization fine = digitize_finely(shape, (d == 2 ? 8 : 4) * aim, rotated);
      EXPECT_LE(fine.calls, std::min(1.25 * std::max(coarse.calls, 0.5), d == 2 ? 2.5 : 1))
          << (rotated ? "rotated" : "shifted");
      EXPECT_EQ(coarse.wrong + fine.wrong, 0);
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

/// Where products of steps and terms are too small for a double, or a phase is lost in its last bits.
TEST(DigitizationExtremes, EqualsSampling) {
  const auto check = [](const Shape<2>& shape, GridStep h) {
    const auto set = gauss_digitize<2>(shape, h);
    EXPECT_EQ(differences<2>(set, shape, h, set.domain()), 0) << "h = " << h.value;
  };
  const auto disk = [](const std::string& formula, double reach) {
    const RealPoint<2> corner = RealPoint<2>::Constant(reach);
    return ImplicitShape<2>(RealPoint<2>::Zero(), Formula(formula), {-corner, corner});
  };
  check(disk("(1e-162*x)^2+(1e-162*y)^2-1e-124", 1.1e100), {1e98});
  check(disk("(1e-160*x)^2+(1e-160*y)^2-1e-120", 1.1e100), {1e98});
  check(disk("(1e150*x)^2+(1e150*y)^2-1e-24", 1.1e-162), {1e-164});
  check(*make_shape<2>("flower:phase=1e15"), {0.05});
}

/// Faces through lattice points, where lengths have but a few bits left.
TEST(DigitizationExtremes, EqualsSamplingOfPolytopesAsSmallAsDoublesGet) {
  RandomStream random{32};
  const LatticeBox<3> around{LatticePoint<3>::Constant(-11), LatticePoint<3>::Constant(11)};
  for (int trial = 0; trial < 100; ++trial) {
    const double h = std::exp2(-1030 - 40 * random.uniform());
    std::vector<ConvexPolytope<3>::Face> faces;
    for (int k = 0; k < 3; ++k)
      for (const double sign : {-1.0, 1.0}) faces.push_back({sign * RealPoint<3>::Unit(k), 10 * h});
    for (int i = 0; i < 4; ++i) {
      RealPoint<3> normal(1 + random.below(3), random.below(4), -double(random.below(4)));
      normal.normalize();
      double offset = 0;
      for (int k = 0; k < 3; ++k) offset += normal[k] * (h * (double(random.below(17)) - 8));
      faces.push_back({normal, std::abs(offset)});
    }
    const RealPoint<3> corner = RealPoint<3>::Constant(10 * h);
    const ConvexPolytope<3> polytope(RealPoint<3>::Zero(), faces, {-corner, corner});
    const auto set = gauss_digitize<3>(polytope, {h});
    EXPECT_EQ(differences<3>(set, polytope, {h}, around), 0) << "h = " << h;
  }
}

TEST(DigitizationErrors, AStepThatIsNotOneOrTooFine) {
  const auto disk = make_shape<2>("disk");
  EXPECT_THROW(gauss_digitize<2>(*disk, {0}), ContractViolation);
  EXPECT_THROW(gauss_digitize<2>(*disk, {1e-9}), InputError);
}

}  // namespace
}  // namespace gridstep
