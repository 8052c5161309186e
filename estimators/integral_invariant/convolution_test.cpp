#include "estimators/integral_invariant/convolution.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <functional>

#include "estimators/integral_invariant/indicator.hpp"
#include "estimators/options.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/scene.hpp"

namespace gridstep {
namespace {

template <int d>
using Points = std::vector<LatticePoint<d>>;

template <int d>
LatticeBox<d> cube(int lo, int hi) {
  return {LatticePoint<d>::Constant(lo), LatticePoint<d>::Constant(hi)};
}

template <int d>
Points<d> points_of(const LatticeBox<d>& box) {
  Points<d> points;
  for_each_point(box, [&](const LatticePoint<d>& z) { points.push_back(z); });
  return points;
}

/// About n distinct points of a box, in no order.
template <int d>
Points<d> random_points(const LatticeBox<d>& box, int n, std::uint64_t seed) {
  RandomStream random({seed});
  Points<d> points;
  for (int i = 0; i < n; ++i) {
    LatticePoint<d> z;
    for (int k = 0; k < d; ++k) z[k] = box.lo[k] + int(random.below(std::uint32_t(box.extent()[k])));
    const bool known = std::any_of(points.begin(), points.end(), [&](const auto& p) { return p == z; });
    if (!known) points.push_back(z);
  }
  return points;
}

/// The inner and outer spels of a boundary, each once.
template <int d>
Points<d> spels_of(const std::vector<Surfel<d>>& surfels) {
  Points<d> points;
  for (const Surfel<d>& surfel : surfels) {
    points.push_back(surfel.inner);
    points.push_back(surfel.outer());
  }
  std::sort(points.begin(), points.end(), raster_less<d>);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// From the definition: the sum of f(x + p) g(p), term by term.
template <class Sum, int d, class Accumulated, class F, class Weight>
std::vector<Sum> naive(const F& f, const Kernel<d, Weight>& kernel, const Points<d>& points) {
  std::vector<Sum> sums;
  for (const LatticePoint<d>& x : points) {
    Sum sum;
    for (const auto& group : kernel.groups)
      for (std::size_t i = group.begin; i < group.end; ++i)
        sum.add(Accumulated(f(LatticePoint<d>(x + kernel.offsets[i]))) * Accumulated(group.weight),
                kernel.offsets[i]);
    sums.push_back(sum);
  }
  return sums;
}

template <class Sum, int d>
void expect_sums_of_a_set(const DigitalSet<d>& set, const Kernel<d, std::int64_t>& kernel,
                          const Points<d>& points) {
  const auto expected =
      naive<Sum, d, std::int64_t>([&](const LatticePoint<d>& z) { return set.contains(z); }, kernel, points);
  const DisplacementMasks<d, std::int64_t> masks(kernel);
  const Indicator<d> f(set);
  EXPECT_TRUE((convolve<Sum, d>(f, kernel, nullptr, points) == expected));
  EXPECT_TRUE((convolve<Sum, d>(f, kernel, &masks, points) == expected));
}

template <int d>
void expect_both_sums(const DigitalSet<d>& set, double r, const Points<d>& points) {
  for (int half_axis = -1; half_axis < d; ++half_axis) {
    const auto kernel = ball_kernel<d>({r}, half_axis);
    expect_sums_of_a_set<PlainSum<d, std::int64_t>>(set, kernel, points);
    expect_sums_of_a_set<MomentSums<d, std::int64_t>>(set, kernel, points);
  }
}

TEST(Convolution, EqualsTheDoubleLoopOnRandomSets) {
  // The sets touch the border of their domains, and kernels reach beyond it.
  for (const double density : {0.05, 0.5, 0.95}) {
    const auto flat = random_set<2>(cube<2>(-64, 63), density, 1);
    expect_both_sums<2>(flat, 3.7, points_of(cube<2>(-9, 9)));
    expect_both_sums<2>(flat, 6, random_points<2>(cube<2>(-80, 80), 150, 2));
    const auto solid = random_set<3>(cube<3>(-20, 43), density, 3);
    expect_both_sums<3>(solid, 2.3, points_of(cube<3>(-4, 4)));
    expect_both_sums<3>(solid, 5, random_points<3>(cube<3>(-30, 70), 150, 4));
  }
}

TEST(Convolution, EqualsTheDoubleLoopOnExtremeSets) {
  DigitalSet<3> voxel(cube<3>(-8, 7));
  voxel.set({-1, 0, 3}, true);
  expect_both_sums<3>(voxel, 3, points_of<3>({{-5, -4, -1}, {4, 4, 7}}));
  expect_both_sums<3>(DigitalSet<3>(cube<3>(0, 1)), 2, points_of(cube<3>(-3, 3)));

  const auto checkerboard =
      set_where<2>(cube<2>(-20, 20), [](const LatticePoint<2>& z) { return ((z[0] + z[1]) & 1) == 0; });
  expect_both_sums<2>(checkerboard, 4.2, points_of(cube<2>(-6, 6)));
  const auto checkerboard_3d =
      set_where<3>(cube<3>(-9, 9), [](const LatticePoint<3>& z) { return (z.sum() & 1) == 0; });
  expect_both_sums<3>(checkerboard_3d, 3.1, points_of(cube<3>(-3, 3)));
}

TEST(Convolution, EqualsTheDoubleLoopAcrossBlocks) {
  // Blocks have 256^2 and 32^3 points: long diagonal runs of 0-adjacent points cross several, on both sides
  // of zero.
  const auto flat = random_set<2>(cube<2>(-600, 600), 0.4, 5);
  Points<2> diagonal;
  for (int i = -520; i <= 520; ++i) diagonal.push_back({i, (i % 2 == 0 ? i : i - 1) / 2});
  expect_both_sums<2>(flat, 5, diagonal);
  const auto solid = random_set<3>(cube<3>(-70, 70), 0.4, 6);
  Points<3> space_diagonal;
  for (int i = -66; i <= 66; ++i) space_diagonal.push_back({i, -i, i});
  std::reverse(space_diagonal.begin(), space_diagonal.end());
  expect_both_sums<3>(solid, 4, space_diagonal);
}

TEST(Convolution, NoPointsNoSums) {
  const DigitalSet<2> set(cube<2>(0, 9));
  const auto kernel = ball_kernel<2>({2});
  const DisplacementMasks<2, std::int64_t> masks(kernel);
  EXPECT_TRUE((convolve<PlainSum<2, std::int64_t>, 2>(Indicator<2>(set), kernel, &masks, {}).empty()));
}

/// A shape functor with values of any type, from a formula.
template <int d, class V>
struct Image {
  using Value = V;
  std::function<V(const LatticePoint<d>&)> value;

  V operator()(const LatticePoint<d>& z) const { return value(z); }
  void fill(const LatticeBox<d>& box, std::span<V> values) const {
    std::size_t i = 0;
    for_each_point(box, [&](const LatticePoint<d>& z) { values[i++] = value(z); });
  }
};

std::int64_t hashed(const LatticePoint<3>& z) {
  return std::int64_t(
      RandomStream({std::uint64_t(z[0] + 99), std::uint64_t(z[1] + 99), std::uint64_t(z[2] + 99)})
          .below(256));
}

template <class V>
void expect_integer_sums(const Image<3, V>& f) {
  const auto points = points_of<3>({{-3, -4, -2}, {3, 2, 5}});
  const auto weight = [](const LatticePoint<3>& z) { return std::int64_t{5 * z[0] - 2 * z[1] * z[2] + 1}; };
  const auto kernel = weighted_kernel<3>({4.4}, weight);
  const DisplacementMasks<3, std::int64_t> masks(kernel);
  using Plain = PlainSum<3, std::int64_t>;
  using Moments = MomentSums<3, std::int64_t>;
  const auto plain = naive<Plain, 3, std::int64_t>(f, kernel, points);
  const auto moments = naive<Moments, 3, std::int64_t>(f, kernel, points);
  for (const auto* m : {static_cast<const DisplacementMasks<3, std::int64_t>*>(nullptr), &masks}) {
    EXPECT_TRUE((convolve<Plain, 3>(f, kernel, m, points) == plain));
    EXPECT_TRUE((convolve<Moments, 3>(f, kernel, m, points) == moments));
  }
}

TEST(Convolution, TakesGreyValuesAndIntegerWeightsExactly) {
  expect_integer_sums(Image<3, std::uint8_t>{[](const auto& z) { return std::uint8_t(hashed(z)); }});
  expect_integer_sums(Image<3, int>{[](const auto& z) { return int(hashed(z)) - 128; }});
}

TEST(Convolution, TakesRealValuesAndRealWeightsToRounding) {
  const Image<3, double> f{[](const auto& z) { return double(hashed(z)) / 255 - 0.4; }};
  const auto kernel = weighted_kernel<3>(
      {5.2}, [](const LatticePoint<3>& z) { return std::exp(-z.squaredNorm() / 9.0) * (1 + 0.1 * z[0]); });
  const DisplacementMasks<3, double> masks(kernel);
  const auto points = points_of<3>({{-3, -4, -2}, {3, 2, 5}});
  using Sum = PlainSum<3, double>;
  const auto expected = naive<Sum, 3, double>(f, kernel, points);
  double scale = 0;  // what rounding is relative to: sums may cancel
  for (const auto& group : kernel.groups) scale += std::abs(group.weight) * double(group.end - group.begin);
  for (const auto* m : {static_cast<const DisplacementMasks<3, double>*>(nullptr), &masks}) {
    const auto sums = convolve<Sum, 3>(f, kernel, m, points);
    ASSERT_EQ(sums.size(), points.size());
    for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(sums[i].n, expected[i].n, 1e-12 * scale);
  }
}

TEST(Convolution, TakesAnIntegerSetWithRealWeights) {
  const auto set = random_set<2>(cube<2>(-20, 20), 0.5, 7);
  const auto kernel =
      weighted_kernel<2>({8}, [](const LatticePoint<2>& z) { return 1 - z.squaredNorm() / 64.0; });
  const DisplacementMasks<2, double> masks(kernel);
  const auto points = points_of(cube<2>(-10, 10));
  using Sum = MomentSums<2, double>;
  const auto full = convolve<Sum, 2>(Indicator<2>(set), kernel, nullptr, points);
  const auto fast = convolve<Sum, 2>(Indicator<2>(set), kernel, &masks, points);
  for (std::size_t i = 0; i < full.size(); ++i) {
    EXPECT_NEAR(fast[i].n, full[i].n, 1e-12 * double(kernel.size()));
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(fast[i].first[k], full[i].first[k], 1e-11 * 8 * double(kernel.size()));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(fast[i].second[k], full[i].second[k], 1e-11 * 64 * double(kernel.size()));
  }
}

/// Sums of a ball kernel over a set, and what they cost.
template <int d>
std::pair<std::vector<PlainSum<d, std::int64_t>>, EvaluationWork> evaluate(const DigitalSet<d>& set, double r,
                                                                           const Points<d>& points,
                                                                           Evaluation evaluation) {
  const auto kernel = ball_kernel<d>({r});
  EvaluationWork work;
  std::vector<PlainSum<d, std::int64_t>> sums;
  if (evaluation == Evaluation::masks) {
    const DisplacementMasks<d, std::int64_t> masks(kernel);
    sums = convolve<PlainSum<d, std::int64_t>, d>(Indicator<d>(set), kernel, &masks, points, &work);
  } else {
    sums = convolve<PlainSum<d, std::int64_t>, d>(Indicator<d>(set), kernel, nullptr, points, &work);
  }
  return {sums, work};
}

TEST(EvaluationWork, OfFullIsEveryCellOfEveryKernel) {
  const auto set = ball_set<3>(9);
  const auto points = spels_of(boundary(set));
  const auto [sums, work] = evaluate<3>(set, 4.5, points, Evaluation::full);
  EXPECT_EQ(work.points, std::int64_t(points.size()));
  EXPECT_EQ(work.cells_visited, std::int64_t(points.size() * ball_kernel<3>({4.5}).size()));
  EXPECT_EQ(work.restarts, 0);
}

TEST(EvaluationWork, GrowsByTheKernelForFullAndByItsSurfaceForMasks) {
  const auto slope = [](auto dimension, double ball, const std::vector<double>& radii,
                        Evaluation evaluation) {
    constexpr int d = decltype(dimension)::value;
    const auto set = ball_set<d>(ball);
    const auto points = spels_of(boundary(set));
    std::vector<double> cells;
    for (const double r : radii)
      cells.push_back(double(evaluate<d>(set, r, points, evaluation).second.cells_visited));
    return log_log_slope(radii, cells);
  };
  const std::integral_constant<int, 2> flat;
  const std::integral_constant<int, 3> solid;
  EXPECT_NEAR(slope(flat, 90, {10, 20, 40, 80}, Evaluation::full), 2, 0.02);
  EXPECT_NEAR(slope(flat, 90, {10, 20, 40, 80}, Evaluation::masks), 1, 0.15);
  EXPECT_NEAR(slope(solid, 16, {4, 8, 16}, Evaluation::full), 3, 0.05);
  EXPECT_NEAR(slope(solid, 30, {5, 10, 20}, Evaluation::masks), 2, 0.15);
}

TEST(EvaluationWork, MasksRestartLessThanOnceInAHundredPoints) {
  const auto restarts = [](auto dimension, const char* spec, double h, double k) {
    constexpr int d = decltype(dimension)::value;
    const auto shape = make_shape<d>(spec);
    SceneSettings<d> settings;
    settings.h = {h};
    const Scene<d> scene = make_scene<d>(*shape, settings);
    const auto points = spels_of(scene.surfels);
    const double r = to_digital(RadiusRule{k}.at({h}), {h}).value;
    const EvaluationWork work = evaluate<d>(scene.set, r, points, Evaluation::masks).second;
    EXPECT_EQ(work.points, std::int64_t(points.size()));
    EXPECT_GE(work.restarts, 1);
    return double(work.restarts) / double(work.points);
  };
  const std::integral_constant<int, 2> flat;
  const std::integral_constant<int, 3> solid;
  EXPECT_LT(restarts(solid, "sphere:radius=5", 0.2, 3), 0.01);
  EXPECT_LT(restarts(solid, "sphere:radius=5", 0.08, 3), 0.01);
  EXPECT_LT(restarts(solid, "goursat", 0.25, 3), 0.01);
  EXPECT_LT(restarts(flat, "flower", 0.1, 5), 0.01);
  EXPECT_LT(restarts(flat, "flower", 0.02, 3), 0.01);
}

TEST(EvaluationWork, AnIsolatedPointIsARestart) {
  const auto set = ball_set<2>(9);
  const auto [sums, work] = evaluate<2>(set, 3, {{0, 0}, {5, 5}, {6, 6}, {-9, 0}}, Evaluation::masks);
  EXPECT_EQ(work.restarts, 3);  // (6, 6) comes from (5, 5)
  EXPECT_EQ(work.points, 4);
}

TEST(Convolution, ResultsAndWorkDoNotDependOnTheNumberOfThreads) {
  const auto set = random_set<3>(cube<3>(-60, 60), 0.5, 8);
  auto points = points_of<3>({{-40, -40, -3}, {40, 40, 3}});
  for (const Evaluation evaluation : {Evaluation::full, Evaluation::masks}) {
    const auto on = [&](std::size_t threads) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      return evaluate<3>(set, 3, points, evaluation);
    };
    const auto one = on(1), two = on(2);
    EXPECT_TRUE(one.first == two.first);
    EXPECT_EQ(one.second.points, two.second.points);
    EXPECT_EQ(one.second.cells_visited, two.second.cells_visited);
    EXPECT_EQ(one.second.restarts, two.second.restarts);
  }
}

TEST(Evaluation, IsNamed) {
  for (const Evaluation evaluation : {Evaluation::full, Evaluation::masks})
    EXPECT_EQ(parse_evaluation(to_string(evaluation)), evaluation);
  try {
    parse_evaluation("fast");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown evaluation 'fast'; known: full, masks, bricks");
  }
}

}  // namespace
}  // namespace gridstep
