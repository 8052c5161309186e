#include "experiments/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "experiments/core/text.hpp"

namespace gridstep {

namespace {

using Point = WorkPrecision::Point;

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / double(values.size());
}

/// Curves that can be compared: of one quantity in one norm on one digitized shape.
struct Comparison {
  std::string shape, quantity, norm;
  double noise;
  std::vector<const WorkPrecision*> curves;
};

std::vector<Comparison> comparisons_of(const std::vector<WorkPrecision>& curves) {
  std::vector<Comparison> result;
  for (const WorkPrecision& curve : curves) {
    auto found = std::find_if(result.begin(), result.end(), [&](const Comparison& c) {
      return c.shape == shape_text(curve) &&
             std::tie(c.quantity, c.norm, c.noise) == std::tie(curve.quantity, curve.norm, curve.noise);
    });
    if (found == result.end())
      found =
          result.insert(found, Comparison{shape_text(curve), curve.quantity, curve.norm, curve.noise, {}});
    found->curves.push_back(&curve);
  }
  std::erase_if(result, [](const Comparison& c) { return c.curves.size() < 2; });
  return result;
}

/// With its radius only where the same estimator comes with several.
std::string title_of(const WorkPrecision& curve, const std::vector<WorkPrecision>& all) {
  for (const WorkPrecision& other : all)
    if (other.estimator == curve.estimator &&
        std::tie(other.k, other.alpha, other.centre) != std::tie(curve.k, curve.alpha, curve.centre))
      return fmt::format("{} {:.4g} h^{:.3g}{}", curve.estimator, curve.k, curve.alpha,
                         curve.centre == "surfel" ? " surfel" : "");
  return curve.estimator;
}

/// A table with one column an estimator; `cell` gives the text for a curve.
class ByEstimator {
 public:
  ByEstimator(std::string title, std::string row_title, const std::vector<WorkPrecision>& curves)
      : curves_(curves) {
    table.title = std::move(title);
    noisy_ = std::any_of(curves.begin(), curves.end(), [](const WorkPrecision& c) { return c.noise > 0; });
    table.columns = {{"shape", Align::left}, {"quantity", Align::left}, {"norm", Align::left}};
    if (noisy_) table.columns.push_back({"noise"});
    table.columns.push_back({std::move(row_title)});
    for (const WorkPrecision& curve : curves) {
      const std::string name = title_of(curve, curves);
      if (std::find(titles_.begin(), titles_.end(), name) == titles_.end()) titles_.push_back(name);
    }
    for (const std::string& name : titles_) table.columns.push_back({name});
  }

  template <class Cell>
  void add_row(const Comparison& comparison, const std::string& head, Cell cell) {
    std::vector<std::string> row{comparison.shape, comparison.quantity, comparison.norm};
    if (noisy_) row.push_back(fmt::format("{:.3g}", comparison.noise));
    row.push_back(head);
    for (const std::string& name : titles_) {
      const auto found = std::find_if(comparison.curves.begin(), comparison.curves.end(),
                                      [&](const WorkPrecision* c) { return title_of(*c, curves_) == name; });
      row.push_back(found == comparison.curves.end() ? "" : cell(**found));
    }
    table.rows.push_back(std::move(row));
  }

  Table table;

 private:
  const std::vector<WorkPrecision>& curves_;
  std::vector<std::string> titles_;
  bool noisy_ = false;
};

/// Round numbers 1, 2, 5 times a power of ten in [low, high], at most `count` of them, evenly chosen.
std::vector<double> round_numbers(double low, double high, std::size_t count) {
  std::vector<double> all;
  for (int power = int(std::floor(std::log10(low))); power <= int(std::ceil(std::log10(high))); ++power)
    for (const double digit : {1.0, 2.0, 5.0})
      if (const double value = digit * std::pow(10.0, power); value >= low && value <= high)
        all.push_back(value);
  std::vector<double> chosen;
  for (std::size_t i = 0; i < std::min(count, all.size()); ++i)
    chosen.push_back(all.size() <= count ? all[i] : all[i * (all.size() - 1) / (count - 1)]);
  return chosen;
}

}  // namespace

std::vector<WorkPrecision> work_precision_of(const std::vector<Convergence>& series,
                                             const std::vector<Cost>& costs) {
  std::vector<WorkPrecision> result;
  for (const Convergence& c : series) {
    std::map<double, double> seconds;  // at h
    for (const Cost& cost : costs)
      if (static_cast<const Setting&>(cost) == c)
        for (const Cost::Step& step : cost.steps) {
          const auto [at, is_new] = seconds.emplace(step.h, step.seconds_eval);
          at->second = std::min(at->second, step.seconds_eval);
        }
    WorkPrecision curve{c, c.quantity, c.norm, {}, c.fit, c.verdict};
    for (const Level& level : c.levels)
      if (const auto at = seconds.find(level.h); at != seconds.end())
        curve.points.push_back({level.h, at->second, mean(level.errors)});
    if (!curve.points.empty()) result.push_back(std::move(curve));
  }
  return result;
}

std::optional<double> where_reached(const WorkPrecision& curve, double error, double Point::*column) {
  std::size_t i = curve.points.size();
  while (i > 0 && curve.points[i - 1].error <= error) --i;
  if (i == curve.points.size()) return std::nullopt;
  const Point& below = curve.points[i];
  if (i == 0 || !(below.error > 0) || !(below.*column > 0)) return below.*column;
  const Point& above = curve.points[i - 1];
  const double part = std::log(above.error / error) / std::log(above.error / below.error);
  return above.*column * std::pow(below.*column / (above.*column), part);
}

Table work_precision_table(const std::vector<WorkPrecision>& curves) {
  ByEstimator by_estimator(
      "Work and precision: evaluation time of the whole boundary until the error is below", "error", curves);
  for (const Comparison& comparison : comparisons_of(curves)) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const WorkPrecision* curve : comparison.curves) {
      low = std::min(low, curve->points.back().error);
      high = std::max(high, curve->points.back().error);
    }
    if (!(low > 0)) continue;
    std::vector<double> errors = round_numbers(low, std::max(high, 10 * low), 4);
    std::reverse(errors.begin(), errors.end());
    for (const double error : errors)
      by_estimator.add_row(comparison, fmt::format("{:.4g}", error), [&](const WorkPrecision& curve) {
        const auto seconds = where_reached(curve, error, &Point::seconds);
        return seconds ? format_seconds(*seconds) : "-";
      });
  }
  return std::move(by_estimator.table);
}

Table equal_error_table(const std::vector<WorkPrecision>& curves) {
  const std::string first = curves.empty() ? "the first" : title_of(curves.front(), curves);
  ByEstimator by_estimator(fmt::format("Equal error: the h' that reaches what {} reaches at h", first), "h",
                           curves);
  for (const Comparison& comparison : comparisons_of(curves)) {
    const std::vector<Point>& base = comparison.curves.front()->points;
    std::vector<std::size_t> steps{0, base.size() / 2, base.size() - 1};
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    for (const std::size_t step : steps) {
      const Point& at = base[step];
      by_estimator.add_row(comparison, fmt::format("{:.4g}", at.h), [&](const WorkPrecision& curve) {
        if (&curve == comparison.curves.front()) return fmt::format("{:.4g}", at.h);
        if (const auto h = where_reached(curve, at.error, &Point::h)) {
          const bool at_coarsest = curve.points.front().error <= at.error && *h == curve.points.front().h;
          return fmt::format("{}{:.4g}", at_coarsest ? ">= " : "", *h);
        }
        // Beyond the range, the fitted line is followed for a decade and a half, no further.
        if (curve.fit.fitted && curve.fit.interval.lower > no_convergence && at.error > 0) {
          const double h = std::pow(at.error / curve.fit.constant, 1 / curve.fit.slope);
          if (h < curve.points.back().h && h > curve.points.back().h / 30) return fmt::format("~{:.2g}", h);
        }
        return std::string("-");
      });
    }
  }
  return std::move(by_estimator.table);
}

nlohmann::ordered_json to_json(const std::vector<WorkPrecision>& curves) {
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for (const WorkPrecision& curve : curves) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const Point& point : curve.points)
      points.push_back({{"h", point.h}, {"seconds", point.seconds}, {"error", point.error}});
    nlohmann::ordered_json json = setting_json(curve);
    json["quantity"] = curve.quantity;
    json["norm"] = curve.norm;
    json["points"] = points;
    result.push_back(std::move(json));
  }
  return result;
}

}  // namespace gridstep
