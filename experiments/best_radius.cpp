#include "experiments/best_radius.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gridstep {

namespace {

bool same_but_for_k(const Convergence& a, const Convergence& b) {
  Setting x = a;
  x.k = b.k;
  return x == static_cast<const Setting&>(b) && a.quantity == b.quantity && a.norm == b.norm;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

}  // namespace

std::vector<RadiusScan> radius_scans_of(const std::vector<Convergence>& series) {
  std::vector<RadiusScan> result;
  for (auto first = series.begin(); first != series.end(); ++first) {
    const auto like_first = [&](const Convergence& other) { return same_but_for_k(*first, other); };
    if (!first->takes_radius() || first->levels.empty() || std::any_of(series.begin(), first, like_first))
      continue;
    const auto [coarsest, finest] = std::minmax_element(
        first->levels.begin(), first->levels.end(), [](const Level& a, const Level& b) { return a.h > b.h; });
    std::vector<double> steps{coarsest->h};
    if (finest->h != coarsest->h) steps.push_back(finest->h);
    for (const double h : steps) {
      RadiusScan scan{*first, first->quantity, first->norm, h, {}, 0};
      for (const Convergence& other : series)
        if (like_first(other))
          for (const Level& level : other.levels)
            if (level.h == h) scan.errors.emplace_back(other.k, mean(level.errors));
      if (scan.errors.size() < 2) continue;
      std::sort(scan.errors.begin(), scan.errors.end());
      std::tie(scan.k, scan.least_error) =
          *std::min_element(scan.errors.begin(), scan.errors.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; });
      result.push_back(std::move(scan));
    }
  }
  return result;
}

Table best_radius_table(const std::vector<RadiusScan>& scans) {
  Table table{"Best radius: the k of R = k h^alpha with the least mean error",
              {{"shape", Align::left},
               {"estimator", Align::left},
               {"quantity", Align::left},
               {"norm", Align::left},
               {"h"},
               {"best k"},
               {"error"},
               {"error at k", Align::left}},
              {}};
  for (const RadiusScan& scan : scans) {
    std::vector<std::string> all;
    for (const auto& [k, error] : scan.errors) all.push_back(fmt::format("{:.4g}: {:.3g}", k, error));
    const char* const mark = scan.k == scan.errors.front().first  ? "<"
                             : scan.k == scan.errors.back().first ? ">"
                                                                  : "";
    table.rows.push_back({shape_text(scan), scan.estimator, scan.quantity, scan.norm,
                          fmt::format("{:.4g}", scan.h), fmt::format("{}{:.4g}", mark, scan.k),
                          fmt::format("{:.4g}", scan.least_error), fmt::format("{}", fmt::join(all, ", "))});
  }
  return table;
}

}  // namespace gridstep
