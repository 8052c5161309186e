#include "estimators/integral_invariant/kernel.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numbers>

#include "estimators/testing_sets.hpp"

namespace gridstep {
namespace {

template <int d>
struct RasterLess {
  bool operator()(const LatticePoint<d>& a, const LatticePoint<d>& b) const { return raster_less<d>(a, b); }
};

/// Offset -> weight; fails where an offset is listed twice.
template <int d, class Weight>
std::map<LatticePoint<d>, Weight, RasterLess<d>> weights_of(const WeightedOffsets<d, Weight>& offsets) {
  std::map<LatticePoint<d>, Weight, RasterLess<d>> result;
  std::size_t end = 0;
  for (const auto& group : offsets.groups) {
    EXPECT_EQ(group.begin, end);
    EXPECT_LT(group.begin, group.end);
    for (std::size_t i = group.begin; i < group.end; ++i) {
      EXPECT_TRUE(result.emplace(offsets.offsets[i], group.weight).second);
      if (i > group.begin) {
        EXPECT_TRUE(raster_less<d>(offsets.offsets[i - 1], offsets.offsets[i]));
      }
    }
    end = group.end;
  }
  EXPECT_EQ(end, offsets.size());
  return result;
}

// Points of Z^2 and Z^3 at distance <= r: the circle and the ball problem of Gauss (OEIS A000328, A000605).
TEST(BallKernel, HoldsTheKnownNumbersOfLatticePoints) {
  const std::map<int, std::pair<std::size_t, std::size_t>> known{
      {1, {5, 7}}, {2, {13, 33}}, {3, {29, 123}}, {4, {49, 257}}, {5, {81, 515}}, {10, {317, 4169}}};
  for (const auto& [r, sizes] : known) {
    EXPECT_EQ(ball_kernel<2>({double(r)}).size(), sizes.first) << r;
    EXPECT_EQ(ball_kernel<3>({double(r)}).size(), sizes.second) << r;
  }
}

TEST(BallKernel, IsClosedAtIntegerRadiiThatAreQuotientsOfDecimals) {
  // 0.3/0.1 < 3 and 0.7/0.1 < 7 in doubles; the ball has its four (six) extreme points all the same.
  for (int n = 1; n <= 60; ++n) {
    const DigitalLength r = to_digital({n * 0.1}, {0.1}), s = to_digital({n / 10.0}, {0.1});
    EXPECT_EQ(ball_kernel<2>(r).size(), ball_kernel<2>({double(n)}).size()) << n;
    EXPECT_EQ(ball_kernel<2>(s).size(), ball_kernel<2>({double(n)}).size()) << n;
  }
  EXPECT_EQ(ball_kernel<3>(to_digital({0.3}, {0.1})).size(), 123u);
}

TEST(BallKernel, EqualsTheDefinition) {
  for (const double r : {1.0, 1.3, std::sqrt(2.0), 2.5, std::sqrt(5.0), 6.7, 13.9})
    for (int half_axis = -1; half_axis < 3; ++half_axis) {
      std::size_t size = 0;
      const auto weights = weights_of<3, std::int64_t>(ball_kernel<3>({r}, half_axis));
      for_each_point(LatticeBox<3>{LatticePoint<3>::Constant(-16), LatticePoint<3>::Constant(16)},
                     [&](const LatticePoint<3>& z) {
                       RealPoint<3> p = z.cast<double>();
                       if (half_axis >= 0) p[half_axis] -= 0.5;
                       if (p.squaredNorm() > r * r * (1 + 1e-12)) return;
                       ++size;
                       EXPECT_EQ(weights.at(z), 1);
                     });
      EXPECT_EQ(weights.size(), size);
    }
}

TEST(BallKernel, AroundASurfelIsSymmetricAboutItsCentre) {
  for (const double r : {1.0, 2.0, 4.5, 9.1})
    for (int axis = 0; axis < 2; ++axis) {
      const auto weights = weights_of<2, std::int64_t>(ball_kernel<2>({r}, axis));
      for (const auto& [z, weight] : weights) {
        for (int k = 0; k < 2; ++k) {
          LatticePoint<2> mirrored = z;
          mirrored[k] = (k == axis ? 1 : 0) - z[k];
          EXPECT_TRUE(weights.contains(mirrored));
        }
        EXPECT_TRUE(ball_kernel<2>({r}, 1 - axis).size() == weights.size());
      }
    }
}

TEST(BallKernel, RefusesRadiiBelowACellOrNotFiniteAndNamesThem) {
  const auto refused = [](double r, const std::string& name) {
    try {
      ball_kernel<3>({r});
      FAIL() << r;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  refused(0.999, "0.999");
  refused(0, "0");
  refused(-3, "-3");
  refused(std::numeric_limits<double>::quiet_NaN(), "nan");
  refused(std::numeric_limits<double>::infinity(), "inf");
  refused(1e12, "1e+12");  // finite, but no kernel of that size can be held
  EXPECT_THROW(ball_kernel<2>({1e12}), InputError);
  EXPECT_NO_THROW(ball_kernel<2>({1.0}));
}

TEST(WeightedKernel, KeepsTheWeightsAndLeavesZerosOut) {
  const auto weight = [](const LatticePoint<2>& z) { return std::int64_t{z[0]} * 3 - z[1]; };
  const auto kernel = weighted_kernel<2>({6.0}, weight);
  const auto weights = weights_of<2, std::int64_t>(kernel);
  std::size_t expected = 0;
  for (const LatticePoint<2>& z : ball_kernel<2>({6.0}).offsets) {
    if (weight(z) == 0) continue;
    ++expected;
    EXPECT_EQ(weights.at(z), weight(z));
  }
  EXPECT_EQ(weights.size(), expected);
  for (std::size_t i = 1; i < kernel.groups.size(); ++i)
    EXPECT_LT(kernel.groups[i - 1].weight, kernel.groups[i].weight);
}

/// delta(p) = g(p) - g(p + e), from the definition.
template <int d, class Weight>
void expect_masks_are_differences(const Kernel<d, Weight>& kernel) {
  const auto g = weights_of<d, Weight>(kernel);
  const auto at = [&g](const LatticePoint<d>& z) {
    const auto found = g.find(z);
    return found == g.end() ? Weight{} : found->second;
  };
  const DisplacementMasks<d, Weight> masks(kernel);
  const LatticePoint<d> reach = LatticePoint<d>::Constant(14);
  for (const LatticePoint<d>& step : DisplacementMasks<d, Weight>::steps()) {
    const auto mask = weights_of<d, Weight>(masks[step]);
    std::size_t size = 0;
    for_each_point(LatticeBox<d>{-reach, reach}, [&](const LatticePoint<d>& p) {
      const Weight delta = at(p) - at(LatticePoint<d>(p + step));
      if (delta == Weight{}) return;
      ++size;
      ASSERT_TRUE(mask.contains(p));
      EXPECT_EQ(mask.at(p), delta);
    });
    EXPECT_EQ(mask.size(), size) << step.transpose();
  }
}

TEST(DisplacementMasks, AreTheDifferencesOfTwoShiftedKernels) {
  for (const double r : {1.0, 2.2, 5.0, 9.7}) {
    expect_masks_are_differences<2, std::int64_t>(ball_kernel<2>({r}));
    expect_masks_are_differences<2, std::int64_t>(ball_kernel<2>({r}, 1));
  }
  for (const double r : {1.0, 3.0, 5.9}) {
    expect_masks_are_differences<3, std::int64_t>(ball_kernel<3>({r}));
    for (int axis = 0; axis < 3; ++axis)
      expect_masks_are_differences<3, std::int64_t>(ball_kernel<3>({r}, axis));
  }
  expect_masks_are_differences<2, std::int64_t>(weighted_kernel<2>(
      {7.0}, [](const LatticePoint<2>& z) { return std::int64_t{2 * z[0] - z[1] * z[1]}; }));
  expect_masks_are_differences<3, double>(
      weighted_kernel<3>({4.0}, [](const LatticePoint<3>& z) { return 1 / (1.0 + z.squaredNorm()); }));
}

TEST(DisplacementMasks, ThereIsOneForEveryNeighbour) {
  EXPECT_EQ((DisplacementMasks<2, std::int64_t>::kCount), 8);
  EXPECT_EQ((DisplacementMasks<3, std::int64_t>::kCount), 26);
  std::map<std::size_t, int> numbers;
  int axes = 1;
  for (const LatticePoint<3>& step : DisplacementMasks<3, std::int64_t>::steps()) {
    EXPECT_EQ(step.cwiseAbs().maxCoeff(), 1);
    EXPECT_GE(step.cwiseAbs().sum(), axes);  // those along one axis first
    axes = step.cwiseAbs().sum();
    ++numbers[DisplacementMasks<3, std::int64_t>::number(step)];
  }
  EXPECT_EQ(numbers.size(), 26u);
  EXPECT_FALSE(numbers.contains(13));  // the null step
}

TEST(DisplacementMasks, OfOppositeStepsMirrorEachOther) {
  // delta_-e(p) = g(p) - g(p - e) = -delta_e(p - e); and g(-p) = g(p), so it is delta_e(-p) too.
  const auto kernel = ball_kernel<3>({6.3});
  const DisplacementMasks<3, std::int64_t> masks(kernel);
  for (const LatticePoint<3>& step : DisplacementMasks<3, std::int64_t>::steps()) {
    const auto there = weights_of<3, std::int64_t>(masks[step]);
    const auto back = weights_of<3, std::int64_t>(masks[-step]);
    ASSERT_EQ(there.size(), back.size());
    for (const auto& [p, weight] : there) {
      EXPECT_EQ(back.at(LatticePoint<3>(p + step)), -weight);
      EXPECT_EQ(back.at(LatticePoint<3>(-p)), weight);
    }
  }
}

template <int d>
std::size_t cells_gained(const WeightedOffsets<d, std::int64_t>& mask) {
  const auto& group = mask.groups.back();
  EXPECT_EQ(group.weight, 1);
  return group.end - group.begin;
}

// "A kernel of 91 893 pixels has 8 displacement masks of about 450 pixels" [Coeurjolly, Lachaud, Levallois].
// What is counted there is one crescent, the cells gained; a mask here also holds as many that are lost.
TEST(DisplacementMasks, AreAsLargeAsInThePaperThatIntroducedThem) {
  std::size_t size = 0;
  double r = 170.9;
  for (; r < 171.1 && size < 91893; r += 0.001) size = ball_kernel<2>({r}).size();
  RecordProperty("radius", std::to_string(r));
  ASSERT_NEAR(double(size), 91893, 30) << "near r = " << r;
  const DisplacementMasks<2, std::int64_t> masks(ball_kernel<2>({171.0}));
  double total = 0;
  for (const LatticePoint<2>& step : DisplacementMasks<2, std::int64_t>::steps()) {
    const std::size_t gained = cells_gained(masks[step]);
    EXPECT_EQ(masks[step].size(), 2 * gained);
    if (step.cwiseAbs().sum() == 1)
      EXPECT_EQ(gained, 2u * 171 + 1);  // one for each row of the ball
    else
      EXPECT_NEAR(double(gained), 343 * std::numbers::sqrt2, 3);
    total += double(gained);
  }
  EXPECT_NEAR(total / 8, 414, 3);
}

TEST(DisplacementMasks, GrowLikeTheSurfaceOfTheBall) {
  const auto slope = [](auto dimension, std::vector<double> radii) {
    constexpr int d = decltype(dimension)::value;
    std::vector<double> sizes;
    for (const double r : radii) {
      const DisplacementMasks<d, std::int64_t> masks(ball_kernel<d>({r}));
      double total = 0;
      for (const LatticePoint<d>& step : DisplacementMasks<d, std::int64_t>::steps())
        total += double(masks[step].size());
      sizes.push_back(total);
    }
    return log_log_slope(radii, sizes);
  };
  EXPECT_NEAR(slope(std::integral_constant<int, 2>(), {10, 20, 40, 80, 160}), 1, 0.03);
  EXPECT_NEAR(slope(std::integral_constant<int, 3>(), {5, 10, 20, 40}), 2, 0.05);
}

}  // namespace
}  // namespace gridstep
