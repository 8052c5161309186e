#include "experiments/core/slope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "shapes/base/contracts.hpp"
#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

double normal_deviate(RandomStream& random) {  // Box and Muller
  return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::numbers::pi * random.uniform());
}

struct Noise {
  double of_level = 0, of_shift = 0;  ///< standard deviations of log(error)
};

/// 7 h^p over h = 1 .. 0.05, times log-normal noise.
std::vector<Level> manufactured(double p, std::size_t steps = 12, Noise noise = {}, std::uint64_t seed = 0) {
  RandomStream random({seed});
  std::vector<Level> levels;
  for (std::size_t i = 0; i < steps; ++i) {
    Level level{std::pow(0.05, double(i) / double(steps - 1)), {}};
    const double common = noise.of_level * normal_deviate(random);
    for (int shift = 0; shift < 10; ++shift)
      level.errors.push_back(7 * std::pow(level.h, p) *
                             std::exp(common + noise.of_shift * normal_deviate(random)));
    levels.push_back(std::move(level));
  }
  return levels;
}

TEST(FitPower, RecoversAManufacturedGrowth) {
  std::vector<double> x, y;
  for (double v = 2; v < 5000; v *= 1.7) {
    x.push_back(v);
    y.push_back(0.3 * v * v * v);
  }
  const LineFit fit = fit_power(x, y);
  EXPECT_NEAR(fit.slope, 3, 1e-12);
  EXPECT_NEAR(fit.constant, 0.3, 1e-12);
  EXPECT_NEAR(fit.standard_error, 0, 1e-12);
}

TEST(FitPower, AgreesWithTheTextbookFormulas) {
  // log2 x = 0 1 2 3, log2 y = 0 2 1 3: slope 0.8, intercept 0.3, residual sum 1.8.
  const LineFit fit = fit_power(std::vector<double>{1, 2, 4, 8}, std::vector<double>{1, 4, 2, 8});
  EXPECT_NEAR(fit.slope, 0.8, 1e-14);
  EXPECT_NEAR(fit.constant, std::exp2(0.3), 1e-14);
  EXPECT_NEAR(fit.standard_error, std::sqrt(1.8 / 2 / 5), 1e-14);
}

TEST(FitPower, RefusesWhatHasNoLine) {
  EXPECT_THROW(fit_power(std::vector<double>{1, 2}, std::vector<double>{1}), ContractViolation);
  EXPECT_THROW(fit_power(std::vector<double>{2, 2}, std::vector<double>{1, 3}), ContractViolation);
  EXPECT_THROW(fit_power(std::vector<double>{1, 2}, std::vector<double>{1, 0}), ContractViolation);
  EXPECT_THROW(fit_power({}, {}), ContractViolation);
}

TEST(FitSlope, RecoversManufacturedPowersInEveryNumber) {
  for (const double p : {1.0 / 3.0, 0.5, 1.0, 2.0}) {
    const SlopeFit fit = fit_slope(manufactured(p), 1);
    EXPECT_EQ(fit.levels, 12u);
    EXPECT_NEAR(fit.slope, p, 1e-12);
    EXPECT_NEAR(fit.constant, 7, 1e-11);
    EXPECT_NEAR(fit.interval.lower, p, 1e-12);
    EXPECT_NEAR(fit.interval.upper, p, 1e-12);
    EXPECT_NEAR(fit.theil_sen, p, 1e-12);
    EXPECT_NEAR(fit.envelope_slope, p, 1e-12);
    ASSERT_EQ(fit.scan.size(), 8u);
    for (std::size_t i = 0; i < fit.scan.size(); ++i) {
      EXPECT_EQ(fit.scan[i].dropped, i);
      EXPECT_DOUBLE_EQ(fit.scan[i].coarsest, manufactured(p)[i].h);
      EXPECT_NEAR(fit.scan[i].slope, p, 1e-12);
    }
    ASSERT_EQ(fit.pairwise.size(), 11u);
    for (const PairwiseOrder& pair : fit.pairwise) EXPECT_NEAR(pair.order, p, 1e-12);
    EXPECT_EQ(judge(fit, p), Verdict::consistent);
  }
}

TEST(FitSlope, TheFirstRowOfTheScanIsTheFitItself) {
  const SlopeFit fit = fit_slope(manufactured(0.5, 12, {0.2, 0.2}, 3), 1);
  EXPECT_NEAR(fit.scan[0].slope, fit.slope, 1e-12);
  EXPECT_EQ(fit.scan[0].interval.lower, fit.interval.lower);
  EXPECT_EQ(fit.scan[0].interval.upper, fit.interval.upper);
}

TEST(FitSlope, TheScanShowsAPreAsymptoticPart) {
  std::vector<Level> levels = manufactured(1.0 / 3.0, 20);
  for (Level& level : levels)
    for (double& error : level.errors) error *= 1 + 3 * level.h;
  const SlopeFit fit = fit_slope(levels, 1);
  EXPECT_GT(fit.slope, 0.6);
  EXPECT_LT(fit.scan.back().slope, 0.52);
  for (std::size_t i = 1; i < fit.scan.size(); ++i) EXPECT_LT(fit.scan[i].slope, fit.scan[i - 1].slope);
}

TEST(FitSlope, TheilSenWithstandsBadLevelsAndTheEnvelopeFollowsTheWorstShift) {
  std::vector<Level> levels = manufactured(0.5);
  for (double& error : levels.back().errors) error *= 100;
  const SlopeFit spoilt = fit_slope(levels, 1);
  EXPECT_LT(spoilt.slope, 0.2);
  EXPECT_NEAR(spoilt.theil_sen, 0.5, 1e-12);

  levels = manufactured(0.5);
  for (Level& level : levels) level.errors[4] = 100;
  const SlopeFit stuck = fit_slope(levels, 1);
  EXPECT_NEAR(stuck.envelope_slope, 0, 1e-12);
  EXPECT_NEAR(stuck.theil_sen, 0.5, 1e-12);
}

TEST(FitSlope, IsDeterministicForASeed) {
  const std::vector<Level> levels = manufactured(0.5, 12, {0.2, 0.2}, 3);
  EXPECT_EQ(fit_slope(levels, 5).interval.lower, fit_slope(levels, 5).interval.lower);
  EXPECT_NE(fit_slope(levels, 5).interval.lower, fit_slope(levels, 6).interval.lower);
  EXPECT_EQ(fit_slope(levels, 5).slope, fit_slope(levels, 6).slope);
}

/// The share of trials whose interval holds the true slope. Its standard deviation at 1000 trials is 0.7 %.
double coverage(std::size_t steps, Noise noise) {
  int inside = 0;
  const int trials = 1000;
  for (int trial = 0; trial < trials; ++trial) {
    const Interval interval = fit_slope(manufactured(0.5, steps, noise, std::uint64_t(trial)), 1).interval;
    inside += interval.lower <= 0.5 && 0.5 <= interval.upper;
  }
  return double(inside) / trials;
}

TEST(FitSlope, TheIntervalHoldsTheTrueSlopeInAbout95PercentOfTrials) {
  for (const Noise noise : {Noise{0.15, 0.1}, Noise{0, 0.3}, Noise{0.3, 0}}) {
    const double share = coverage(12, noise);
    EXPECT_GE(share, 0.935);
    EXPECT_LE(share, 0.98);
  }
}

TEST(FitSlope, WithFewLevelsTheIntervalErrsOnTheWideSide) {
  EXPECT_GE(coverage(fewest_levels, {0.15, 0.1}), 0.95);
}

TEST(FitSlope, SaysWhenThereIsNothingToFit) {
  EXPECT_FALSE(fit_slope({}, 1).fitted);
  EXPECT_FALSE(fit_slope(std::vector<Level>{{0.5, {1, 2}}}, 1).fitted);
  const SlopeFit zeros = fit_slope(std::vector<Level>{{1, {0, 0}}, {0.5, {0}}, {0.25, {1}}}, 1);
  EXPECT_FALSE(zeros.fitted);
  EXPECT_EQ(zeros.zero_errors, 3u);
  const SlopeFit few = fit_slope(std::vector<Level>{{1, {2}}, {0.5, {1}}}, 1);
  EXPECT_TRUE(few.fitted);
  EXPECT_NEAR(few.slope, 1, 1e-12);
  EXPECT_EQ(few.interval.width(), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(few.scan.empty());
}

TEST(FitSlope, RefusesBadLevels) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<Level>& bad : {std::vector<Level>{{0.5, {1}}, {1, {1}}},
                                        {{1, {1}}, {1, {1}}},
                                        {{0, {1}}},
                                        {{nan, {1}}},
                                        {{1, {}}},
                                        {{1, {nan}}},
                                        {{1, {-1}}}})
    EXPECT_THROW(fit_slope(bad, 1), ContractViolation);
}

Verdict verdict_of(const std::vector<Level>& levels, double expected) {
  return judge(fit_slope(levels, 1), expected);
}

TEST(Judge, ReachesEveryVerdict) {
  const Noise some{0.05, 0.1};
  EXPECT_EQ(verdict_of(manufactured(1.0 / 3.0, 12, some), 1.0 / 3.0), Verdict::consistent);
  EXPECT_EQ(verdict_of(manufactured(1.0, 12, some), 1.0 / 3.0), Verdict::faster);
  EXPECT_EQ(verdict_of(manufactured(0.2, 12, some), 1.0 / 3.0), Verdict::slower);
  EXPECT_EQ(verdict_of(manufactured(0, 12, some), 1.0 / 3.0), Verdict::not_converging);
  EXPECT_EQ(verdict_of(manufactured(1.0 / 3.0, 12, {2, 1}), 1.0 / 3.0), Verdict::undecided);
}

TEST(Judge, AConstantErrorDoesNotConvergeAndAGrowingOneNeither) {
  EXPECT_EQ(verdict_of(manufactured(0), 1.0 / 3.0), Verdict::not_converging);
  EXPECT_EQ(verdict_of(manufactured(-1), 1.0 / 3.0), Verdict::not_converging);
  EXPECT_EQ(verdict_of(manufactured(-3, 12, {1.0, 0}), 1.0 / 3.0), Verdict::not_converging);
}

TEST(Judge, IsUndecidedOnFourLevelsAndOnAnExactZero) {
  EXPECT_EQ(verdict_of(manufactured(0.5, 4), 0.5), Verdict::undecided);
  EXPECT_EQ(verdict_of(manufactured(0.5, 5), 0.5), Verdict::consistent);
  std::vector<Level> levels = manufactured(0.5);
  levels[3].errors[2] = 0;
  EXPECT_EQ(verdict_of(levels, 0.5), Verdict::undecided);
}

SlopeFit with_interval(double lower, double upper) {
  SlopeFit fit;
  fit.levels = 12;
  fit.fitted = true;
  fit.interval = {lower, upper};
  return fit;
}

TEST(Judge, ReadsTheIntervalAsDocumented) {
  const double p = 0.5;
  EXPECT_EQ(judge(with_interval(0.45, 0.52), p), Verdict::consistent);
  EXPECT_EQ(judge(with_interval(0.505, 0.52), p), Verdict::consistent);  // within the resolution
  EXPECT_EQ(judge(with_interval(0.47, 0.495), p), Verdict::consistent);
  EXPECT_EQ(judge(with_interval(0.515, 0.52), p), Verdict::faster);
  EXPECT_EQ(judge(with_interval(0.9, 2.9), p), Verdict::faster);  // wide, but all of it above p
  EXPECT_EQ(judge(with_interval(0.47, 0.485), p), Verdict::slower);
  EXPECT_EQ(judge(with_interval(-0.1, 0.2), p), Verdict::slower);
  EXPECT_EQ(judge(with_interval(-0.1, 0.05), p), Verdict::not_converging);
  EXPECT_EQ(judge(with_interval(-0.01, 0.495), p), Verdict::undecided);  // reaches 0
  EXPECT_EQ(judge(with_interval(0.2, 0.8), p), Verdict::undecided);      // wider than p
  EXPECT_EQ(judge(with_interval(-1, 3), p), Verdict::undecided);
  EXPECT_THROW(judge(with_interval(0, 1), 0.05), ContractViolation);
}

TEST(Verdict, HasItsNames) {
  EXPECT_EQ(to_string(Verdict::consistent), "consistent");
  EXPECT_EQ(to_string(Verdict::faster), "faster");
  EXPECT_EQ(to_string(Verdict::slower), "slower");
  EXPECT_EQ(to_string(Verdict::not_converging), "not converging");
  EXPECT_EQ(to_string(Verdict::undecided), "undecided");
}

TEST(Verdict, AFasterDecayConfirmsAnUpperBound) {
  EXPECT_TRUE(confirms(Verdict::consistent));
  EXPECT_TRUE(confirms(Verdict::faster));
  for (const Verdict verdict : {Verdict::slower, Verdict::not_converging, Verdict::undecided})
    EXPECT_FALSE(confirms(verdict));
}

}  // namespace
}  // namespace gridstep
