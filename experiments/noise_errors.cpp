#include "experiments/noise_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace gridstep {

namespace {

Setting without_noise(Setting setting) {
  setting.noise = 0;
  return setting;
}

bool same_but_for_noise(const Convergence& a, const Convergence& b) {
  return without_noise(a) == without_noise(b) && a.quantity == b.quantity && a.norm == b.norm;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

const char* mark(Verdict verdict) {
  return verdict == Verdict::not_converging ? "*" : verdict == Verdict::undecided ? "?" : "";
}

}  // namespace

std::vector<NoiseErrors> noise_errors_of(const std::vector<Convergence>& series) {
  std::vector<NoiseErrors> result;
  for (auto first = series.begin(); first != series.end(); ++first) {
    const auto like_first = [&](const Convergence& other) { return same_but_for_noise(*first, other); };
    if (std::any_of(series.begin(), first, like_first)) continue;
    NoiseErrors entry{without_noise(*first), first->quantity, first->norm, first->levels.back().h, {}};
    for (const Convergence& other : series)
      if (like_first(other))
        for (const Level& level : other.levels)
          if (level.h == entry.h) entry.levels.push_back({other.noise, mean(level.errors), other.verdict});
    if (entry.levels.size() < 2) continue;
    std::sort(entry.levels.begin(), entry.levels.end(),
              [](const NoiseErrors::At& a, const NoiseErrors::At& b) { return a.beta < b.beta; });
    result.push_back(std::move(entry));
  }
  return result;
}

Table noise_table(const std::vector<NoiseErrors>& entries) {
  const auto left = Align::left;
  Table table{
      "Noise: mean error at each beta, at the finest h; * where it does not fall as h does, ? undecided",
      {{"shape", left}, {"estimator", left}, {"R", left}, {"quantity", left}, {"norm", left}, {"h"}},
      {}};
  std::set<double> betas;
  for (const NoiseErrors& entry : entries)
    for (const NoiseErrors::At& level : entry.levels) betas.insert(level.beta);
  for (const double beta : betas) table.columns.push_back({fmt::format("{:.3g}", beta)});
  for (const NoiseErrors& entry : entries) {
    std::vector<std::string> row{shape_text(entry), entry.estimator, radius_text(entry),
                                 entry.quantity,    entry.norm,      fmt::format("{:.4g}", entry.h)};
    for (const double beta : betas) {
      const auto at = std::find_if(entry.levels.begin(), entry.levels.end(),
                                   [&](const NoiseErrors::At& level) { return level.beta == beta; });
      row.push_back(at == entry.levels.end() ? "" : fmt::format("{:.4g}{}", at->error, mark(at->verdict)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace gridstep
