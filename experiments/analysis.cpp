#include "experiments/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "experiments/compared.hpp"
#include "experiments/core/text.hpp"

namespace gridstep {

using nlohmann::ordered_json;

namespace {

constexpr std::pair<const char*, double ErrorNorms::*> kNorms[] = {
    {"sup", &ErrorNorms::sup}, {"rms", &ErrorNorms::rms}, {"mean", &ErrorNorms::mean}};

/// Values in the order of their first appearance under a key.
template <class Key, class Value>
class Grouped {
 public:
  Value& operator[](const Key& key) {
    const auto [found, is_new] = position_.emplace(key, values.size());
    if (is_new) values.emplace_back();
    return values[found->second];
  }
  std::vector<Value> values;

 private:
  std::map<Key, std::size_t> position_;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

/// The column of centres is only there where one is not the usual one.
template <class Row>
bool has_other_centres(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const Row& row) { return row.takes_radius() && row.centre != "spels"; });
}

/// What the theorem on a quantity says for this radius. Theorems speak of Gauss digitization, without noise.
std::optional<double> expected_exponent(const Setting& setting, const std::string& quantity) {
  if (setting.noise > 0) return std::nullopt;
  for (const Compared& compared : compared_quantities(setting.estimator, setting.dimension))
    if (compared.name == quantity && compared.proven_rate)
      return setting.takes_radius() ? proven_exponent(setting.alpha) : compared.proven_rate;
  return std::nullopt;
}

}  // namespace

std::optional<double> proven_exponent(double alpha) {
  const double exponent = std::min(alpha, 1 - 2 * alpha);
  return exponent > no_convergence ? std::optional(exponent) : std::nullopt;
}

std::string shape_text(const Setting& setting) {
  return setting.rotated ? setting.shape + ", rotated" : setting.shape;
}

std::string radius_text(const Setting& setting) {
  return setting.takes_radius() ? fmt::format("{:.4g} h^{:.3g}", setting.k, setting.alpha) : "-";
}

std::vector<Convergence> convergence_of(const std::vector<Record>& records, std::uint64_t seed) {
  Grouped<std::tuple<Setting, std::string, std::string>, Convergence> series;
  // The step is part of the key: one sweep may take the whole kernel at coarse steps, another one masks at
  // fine ones.
  std::map<std::pair<Setting, double>, std::string> first_evaluation;
  for (const Record& record : records) {
    const Setting& setting = record;
    const auto first = first_evaluation.emplace(std::pair(setting, record.h), record.evaluation).first;
    if (first->second != record.evaluation) continue;
    for (const auto& [quantity, norms] : record.errors)
      for (const auto& [norm, member] : kNorms) {
        Convergence& c = series[{setting, quantity, norm}];
        if (c.levels.empty()) {
          static_cast<Setting&>(c) = setting;
          c.quantity = quantity;
          c.norm = norm;
        }
        auto level =
            std::find_if(c.levels.begin(), c.levels.end(), [&](const Level& l) { return l.h == record.h; });
        if (level == c.levels.end()) level = c.levels.insert(level, Level{record.h, {}});
        level->errors.push_back(norms.*member);
      }
  }
  for (Convergence& c : series.values) {
    std::sort(c.levels.begin(), c.levels.end(), [](const Level& a, const Level& b) { return a.h > b.h; });
    c.fit = fit_slope(c.levels, seed);
    c.expected = expected_exponent(c, c.quantity);
    c.verdict = c.expected ? judge(c.fit, *c.expected) : judge(c.fit);
  }
  return std::move(series.values);
}

std::vector<Cost> costs_of(const std::vector<Record>& records) {
  struct Samples {
    const Record* record = nullptr;
    std::map<double, std::vector<const Record*>, std::greater<>> by_step;
  };
  Grouped<std::pair<Setting, std::string>, Samples> groups;
  for (const Record& record : records) {
    Samples& samples = groups[{record, record.evaluation}];
    samples.record = &record;
    samples.by_step[record.h].push_back(&record);
  }
  std::vector<Cost> costs;
  for (const Samples& samples : groups.values) {
    const Record& r = *samples.record;
    Cost cost{r, r.evaluation, {}};
    for (const auto& [h, at_step] : samples.by_step) {
      const auto middle = [&](auto field) {
        std::vector<double> values;
        for (const Record* record : at_step) values.push_back(double(field(*record)));
        return median(std::move(values));
      };
      cost.steps.push_back({h, at_step.front()->digital_radius,
                            middle([](const Record& x) { return x.surfels; }),
                            middle([](const Record& x) { return x.seconds_init; }),
                            middle([](const Record& x) { return x.seconds_eval; }),
                            middle([](const Record& x) { return x.work.cells_visited; }),
                            middle([](const Record& x) { return x.work.restarts; }),
                            middle([](const Record& x) { return x.work.evaluations; }),
                            middle([](const Record& x) { return x.work.fallbacks; })});
    }
    costs.push_back(std::move(cost));
  }
  return costs;
}

Table convergence_table(const std::vector<Convergence>& series) {
  const auto left = Align::left;
  Table table{"Convergence: error = C h^slope",
              {{"shape", left},
               {"estimator", left},
               {"R", left},
               {"quantity", left},
               {"norm", left},
               {"h"},
               {"error"},
               {"h"},
               {"error"},
               {"slope"},
               {"95 %"},
               {"robust"},
               {"envelope"},
               {"theory"},
               {"verdict", left}},
              {}};
  const bool noisy =
      std::any_of(series.begin(), series.end(), [](const Convergence& c) { return c.noise > 0; });
  if (noisy) table.columns.insert(table.columns.begin() + 1, Column{"noise"});
  const bool centred = has_other_centres(series);
  if (centred) table.columns.insert(table.columns.begin() + 1, Column{"centre", left});
  for (const Convergence& c : series) {
    const auto mean = [](const Level& level) {
      double sum = 0;
      for (const double e : level.errors) sum += e;
      return sum / double(level.errors.size());
    };
    std::vector<std::string> row{shape_text(c),
                                 c.estimator,
                                 radius_text(c),
                                 c.quantity,
                                 c.norm,
                                 fmt::format("{:.4g}", c.levels.front().h),
                                 format_error(mean(c.levels.front())),
                                 fmt::format("{:.4g}", c.levels.back().h),
                                 format_error(mean(c.levels.back())),
                                 c.fit.fitted ? format_slope(c.fit.slope) : "-",
                                 format_interval(c.fit.interval),
                                 c.fit.fitted ? format_slope(c.fit.theil_sen) : "-",
                                 c.fit.fitted ? format_slope(c.fit.envelope_slope) : "-",
                                 c.expected ? format_slope(*c.expected) : "-",
                                 std::string(to_string(c.verdict))};
    if (noisy) row.insert(row.begin() + 1, fmt::format("{:.3g}", c.noise));
    if (centred) row.insert(row.begin() + 1, c.takes_radius() ? c.centre : "-");
    table.rows.push_back(std::move(row));
  }
  return table;
}

namespace {

/// Exponent of a cost against x, or nothing where there are fewer than two steps.
template <class X, class Y>
std::optional<double> growth(const Cost& cost, X x, Y y) {
  std::vector<double> xs, ys;
  for (const Cost::Step& step : cost.steps)
    if (y(step) > 0) {
      xs.push_back(x(step));
      ys.push_back(y(step));
    }
  if (std::set<double>(xs.begin(), xs.end()).size() < 2) return std::nullopt;
  return fit_power(xs, ys).slope;
}

const auto kStep = [](const Cost::Step& s) { return s.h; };
const auto kRadius = [](const Cost::Step& s) { return s.digital_radius; };
const auto kSeconds = [](const Cost::Step& s) { return s.seconds_eval; };
const auto kSecondsEach = [](const Cost::Step& s) { return s.seconds_eval / s.surfels; };
const auto kCells = [](const Cost::Step& s) { return s.cells_visited; };
const auto kCellsEach = [](const Cost::Step& s) { return s.cells_visited / s.evaluations; };

std::string exponent_text(const std::optional<double>& exponent) {
  return exponent ? fmt::format("{:.2f}", *exponent) : "-";
}

/// What is read on a whole surface grows like h^-(d-1) surfels times (R/h)^d, (R/h)^(d-1) or, by bricks,
/// (R/h)^(d-2); R = k h^alpha.
std::optional<double> expected_growth(const Cost& cost) {
  if (!cost.takes_radius() || cost.evaluation.empty()) return std::nullopt;
  const int less = cost.evaluation == "full" ? 0 : cost.evaluation == "masks" ? 1 : 2;
  const int per_surfel = cost.dimension - less;
  return -(cost.dimension - 1) - per_surfel * (1 - cost.alpha);
}

}  // namespace

Table cost_table(const std::vector<Cost>& costs) {
  const auto left = Align::left;
  Table table{
      "Cost: evaluation at the finest h, and growth exponents (in h: whole surface; in R/h: one point)",
      {{"shape", left},
       {"estimator", left},
       {"R", left},
       {"evaluation", left},
       {"h"},
       {"R/h"},
       {"surfels"},
       {"init"},
       {"eval"},
       {"ns/surfel"},
       {"cells/surfel"},
       {"restarts"},
       {"vs full"},
       {"time~h"},
       {"cells~h"},
       {"theory"},
       {"cells~R/h"},
       {"time~R/h"}},
      {}};
  const bool centred = has_other_centres(costs);
  if (centred) table.columns.insert(table.columns.begin() + 1, Column{"centre", left});
  for (const Cost& cost : costs) {
    if (cost.noise > 0) continue;  // the same work on a longer boundary
    const Cost::Step& last = cost.steps.back();
    std::string ratio = "-";
    for (const Cost& full : costs)
      if (full.evaluation == "full" && cost.evaluation != "full" &&
          static_cast<const Setting&>(full) == cost && last.seconds_eval > 0)
        for (const Cost::Step& step : full.steps)
          if (step.h == last.h) ratio = fmt::format("{:.1f}x", step.seconds_eval / last.seconds_eval);
    std::vector<std::string> row{shape_text(cost),
                                 cost.estimator,
                                 radius_text(cost),
                                 cost.evaluation.empty() ? "-" : cost.evaluation,
                                 fmt::format("{:.4g}", last.h),
                                 cost.takes_radius() ? fmt::format("{:.4g}", last.digital_radius) : "-",
                                 fmt::format("{:.0f}", last.surfels),
                                 format_seconds(last.seconds_init),
                                 format_seconds(last.seconds_eval),
                                 fmt::format("{:.0f}", 1e9 * kSecondsEach(last)),
                                 fmt::format("{:.0f}", last.cells_visited / last.surfels),
                                 fmt::format("{:.2f} %", 100 * last.restarts / last.evaluations),
                                 ratio,
                                 exponent_text(growth(cost, kStep, kSeconds)),
                                 exponent_text(growth(cost, kStep, kCells)),
                                 exponent_text(expected_growth(cost)),
                                 exponent_text(growth(cost, kRadius, kCellsEach)),
                                 exponent_text(growth(cost, kRadius, kSecondsEach))};
    if (centred) row.insert(row.begin() + 1, cost.takes_radius() ? cost.centre : "-");
    table.rows.push_back(std::move(row));
  }
  return table;
}

namespace {

ordered_json number_or_null(double x) {
  return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr);
}
ordered_json interval_json(const Interval& i) {
  return {number_or_null(i.lower), number_or_null(i.upper)};
}
template <class T>
ordered_json optional_json(const std::optional<T>& x) {
  return x ? ordered_json(*x) : ordered_json(nullptr);
}
}  // namespace

ordered_json to_json(const std::vector<Convergence>& series) {
  ordered_json result = ordered_json::array();
  for (const Convergence& c : series) {
    ordered_json levels = ordered_json::array(), scan = levels, pairwise = levels;
    for (const Level& level : c.levels) levels.push_back({{"h", level.h}, {"errors", level.errors}});
    for (const ScanRow& row : c.fit.scan)
      scan.push_back({{"dropped", row.dropped},
                      {"coarsest", row.coarsest},
                      {"slope", row.slope},
                      {"interval", interval_json(row.interval)}});
    for (const PairwiseOrder& p : c.fit.pairwise)
      pairwise.push_back({{"coarse", p.coarse}, {"fine", p.fine}, {"order", p.order}});
    ordered_json json = setting_json(c);
    json.update({{"quantity", c.quantity},
                 {"norm", c.norm},
                 {"slope", c.fit.slope},
                 {"constant", c.fit.constant},
                 {"interval", interval_json(c.fit.interval)},
                 {"theil_sen", c.fit.theil_sen},
                 {"envelope_slope", c.fit.envelope_slope},
                 {"expected", optional_json(c.expected)},
                 {"verdict", to_string(c.verdict)},
                 {"zero_errors", c.fit.zero_errors},
                 {"levels", levels},
                 {"scan", scan},
                 {"pairwise", pairwise}});
    result.push_back(std::move(json));
  }
  return result;
}

ordered_json to_json(const std::vector<Cost>& costs) {
  ordered_json result = ordered_json::array();
  for (const Cost& cost : costs) {
    ordered_json steps = ordered_json::array();
    for (const Cost::Step& s : cost.steps)
      steps.push_back({{"h", s.h},
                       {"digital_radius", s.digital_radius},
                       {"surfels", s.surfels},
                       {"seconds_init", s.seconds_init},
                       {"seconds_eval", s.seconds_eval},
                       {"cells_visited", s.cells_visited},
                       {"restarts", s.restarts},
                       {"evaluations", s.evaluations},
                       {"fallbacks", s.fallbacks}});
    ordered_json json = setting_json(cost);
    json.update({{"evaluation", cost.evaluation.empty() ? ordered_json() : ordered_json(cost.evaluation)},
                 {"time_in_h", optional_json(growth(cost, kStep, kSeconds))},
                 {"cells_in_h", optional_json(growth(cost, kStep, kCells))},
                 {"expected_in_h", optional_json(expected_growth(cost))},
                 {"cells_in_radius", optional_json(growth(cost, kRadius, kCellsEach))},
                 {"time_in_radius", optional_json(growth(cost, kRadius, kSecondsEach))},
                 {"steps", steps}});
    result.push_back(std::move(json));
  }
  return result;
}

}  // namespace gridstep
