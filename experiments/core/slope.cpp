#include "experiments/core/slope.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

#include "shapes/base/contracts.hpp"
#include "shapes/base/random.hpp"

namespace gridstep {

namespace {

constexpr std::size_t resamples = 2000;

bool is_positive(double value) {
  return value > 0 && std::isfinite(value);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// What a level contributes to least squares.
struct LogLevel {
  double x;      ///< log h
  double y;      ///< mean of log(error)
  double count;  ///< of errors
};

/// Slope of the least-squares line through `indices` of levels, with repetition; the caller sees to two
/// distinct ones.
double slope_of(std::span<const LogLevel> levels, std::span<const std::uint32_t> indices) {
  double count = 0, x = 0, y = 0;
  for (const std::uint32_t i : indices) {
    count += levels[i].count;
    x += levels[i].count * levels[i].x;
    y += levels[i].count * levels[i].y;
  }
  x /= count;
  y /= count;
  double xx = 0, xy = 0;
  for (const std::uint32_t i : indices) {
    const double dx = levels[i].x - x;
    xx += levels[i].count * dx * dx;
    xy += levels[i].count * dx * (levels[i].y - y);
  }
  return xy / xx;
}

double lower_tail(std::size_t levels) {
  const double n = double(levels);
  const boost::math::students_t_distribution<double> student(n - 2);
  const double t = boost::math::quantile(boost::math::complement(student, 0.025));
  return boost::math::cdf(boost::math::normal_distribution<double>(), -std::sqrt(n / (n - 2)) * t);
}

double percentile(std::span<const double> sorted, double probability) {
  const double position = probability * double(sorted.size() - 1);
  const std::size_t i = std::min(std::size_t(position), sorted.size() - 2);
  return std::lerp(sorted[i], sorted[i + 1], position - double(i));
}

Interval bootstrap_interval(std::span<const LogLevel> levels, std::uint64_t seed) {
  if (levels.size() < fewest_levels) return {};
  RandomStream random({seed, levels.size()});
  std::vector<std::uint32_t> drawn(levels.size());
  std::vector<double> slopes(resamples);
  for (double& slope : slopes) {
    do {
      for (std::uint32_t& i : drawn) i = random.below(std::uint32_t(levels.size()));
    } while (std::all_of(drawn.begin(), drawn.end(), [&](std::uint32_t i) { return i == drawn.front(); }));
    slope = slope_of(levels, drawn);
  }
  std::sort(slopes.begin(), slopes.end());
  const double tail = lower_tail(levels.size());
  return {percentile(slopes, tail), percentile(slopes, 1 - tail)};
}

}  // namespace

LineFit fit_power(std::span<const double> x, std::span<const double> y) {
  expects(x.size() == y.size(), "as many x as y");
  expects(std::all_of(x.begin(), x.end(), is_positive), "positive, finite x");
  expects(std::all_of(y.begin(), y.end(), is_positive), "positive, finite y");
  expects(std::any_of(x.begin(), x.end(), [&](double v) { return v != x.front(); }), "two distinct x");

  const Eigen::Index n = Eigen::Index(x.size());
  Eigen::MatrixX2d design(n, 2);
  Eigen::VectorXd logs(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    design.row(i) << 1, std::log(x[std::size_t(i)]);
    logs[i] = std::log(y[std::size_t(i)]);
  }
  // Centred, the two columns are orthogonal, and no digits of the slope are lost to the intercept.
  const double centre = design.col(1).mean();
  design.col(1).array() -= centre;
  const Eigen::Vector2d line = design.householderQr().solve(logs);
  const double residual = (logs - design * line).squaredNorm();
  const double variance = n > 2 ? residual / double(n - 2) : 0;
  return {line[1], std::exp(line[0] - line[1] * centre), std::sqrt(variance / design.col(1).squaredNorm())};
}

SlopeFit fit_slope(std::span<const Level> levels, std::uint64_t seed) {
  SlopeFit fit;
  std::vector<double> h_of_point, error_of_point, h_of_level, largest, medians;
  std::vector<LogLevel> logs;
  double previous = std::numeric_limits<double>::infinity();
  for (const Level& level : levels) {
    expects(is_positive(level.h) && level.h < previous, "positive, strictly decreasing h");
    expects(!level.errors.empty(), "at least one error a level");
    previous = level.h;
    std::vector<double> log_errors;
    for (const double error : level.errors) {
      expects(error >= 0 && std::isfinite(error), "finite errors >= 0");
      if (error == 0) {
        ++fit.zero_errors;
        continue;
      }
      h_of_point.push_back(level.h);
      error_of_point.push_back(error);
      log_errors.push_back(std::log(error));
    }
    if (log_errors.empty()) continue;
    const double count = double(log_errors.size());
    logs.push_back(
        {std::log(level.h), std::accumulate(log_errors.begin(), log_errors.end(), 0.0) / count, count});
    h_of_level.push_back(level.h);
    largest.push_back(*std::max_element(level.errors.begin(), level.errors.end()));
    medians.push_back(median(std::move(log_errors)));
  }

  fit.levels = logs.size();
  fit.fitted = fit.levels >= 2;
  if (!fit.fitted) return fit;

  const LineFit line = fit_power(h_of_point, error_of_point);
  fit.slope = line.slope;
  fit.constant = line.constant;
  fit.interval = bootstrap_interval(logs, seed);
  fit.envelope_slope = fit_power(h_of_level, largest).slope;

  std::vector<double> pair_slopes;
  for (std::size_t i = 0; i < logs.size(); ++i)
    for (std::size_t j = i + 1; j < logs.size(); ++j)
      pair_slopes.push_back((medians[i] - medians[j]) / (logs[i].x - logs[j].x));
  fit.theil_sen = median(std::move(pair_slopes));

  for (std::size_t i = 0; i + 1 < logs.size(); ++i)
    fit.pairwise.push_back(
        {h_of_level[i], h_of_level[i + 1], (logs[i].y - logs[i + 1].y) / (logs[i].x - logs[i + 1].x)});

  for (std::size_t dropped = 0; dropped + fewest_levels <= logs.size(); ++dropped) {
    const std::span<const LogLevel> kept = std::span(logs).subspan(dropped);
    std::vector<std::uint32_t> all(kept.size());
    std::iota(all.begin(), all.end(), 0u);
    fit.scan.push_back({dropped, h_of_level[dropped], slope_of(kept, all), bootstrap_interval(kept, seed)});
  }
  return fit;
}

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::consistent:
      return "consistent";
    case Verdict::faster:
      return "faster";
    case Verdict::slower:
      return "slower";
    case Verdict::converging:
      return "converging";
    case Verdict::not_converging:
      return "not converging";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

Verdict judge(const SlopeFit& fit) {
  if (fit.levels < fewest_levels || fit.zero_errors > 0) return Verdict::undecided;
  if (fit.interval.upper <= no_convergence) return Verdict::not_converging;
  return fit.interval.lower > no_convergence ? Verdict::converging : Verdict::undecided;
}

Verdict judge(const SlopeFit& fit, double expected) {
  expects(expected > no_convergence && std::isfinite(expected), "an expected exponent above no_convergence");
  const Verdict at_all = judge(fit);
  if (fit.levels < fewest_levels || fit.zero_errors > 0 || at_all == Verdict::not_converging) return at_all;
  if (fit.interval.lower > expected + slope_resolution) return Verdict::faster;
  if (fit.interval.upper < expected - slope_resolution) return Verdict::slower;
  const bool narrow = fit.interval.lower > 0 && fit.interval.width() <= expected;
  return narrow ? Verdict::consistent : Verdict::undecided;
}

}  // namespace gridstep
