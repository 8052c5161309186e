#include "experiments/fallbacks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>

#include "experiments/analysis.hpp"

namespace gridstep {

std::vector<Fallbacks> fallbacks_of(const std::vector<Record>& records) {
  std::vector<Fallbacks> result;
  std::map<Setting, std::size_t> position;
  std::map<std::pair<Setting, double>, std::string> first_evaluation;
  for (const Record& record : records) {
    const Setting& setting = record;
    const auto first = first_evaluation.emplace(std::pair(setting, record.h), record.evaluation).first;
    if (first->second != record.evaluation) continue;
    const auto [at, is_new] = position.emplace(setting, result.size());
    if (is_new) result.push_back({setting, {}});
    Fallbacks::Count& count = result[at->second].by_step[record.h];
    count.fallbacks += record.work.fallbacks;
    count.surfels += record.surfels;
  }
  std::erase_if(result, [](const Fallbacks& entry) {
    return std::all_of(entry.by_step.begin(), entry.by_step.end(),
                       [](const auto& step) { return step.second.fallbacks == 0; });
  });
  return result;
}

Table fallback_table(const std::vector<Fallbacks>& fallbacks) {
  const auto left = Align::left;
  Table table{"Fallbacks: of how many surfels, over all shifts, a guard took another kernel",
              {{"shape", left}, {"estimator", left}, {"R", left}, {"at h", left}},
              {}};
  const bool noisy =
      std::any_of(fallbacks.begin(), fallbacks.end(), [](const Fallbacks& f) { return f.noise > 0; });
  if (noisy) table.columns.insert(table.columns.begin() + 1, Column{"noise"});
  for (const Fallbacks& entry : fallbacks) {
    std::vector<std::string> steps;
    for (const auto& [h, count] : entry.by_step)
      steps.push_back(count.fallbacks == 0
                          ? fmt::format("{:.4g}: none", h)
                          : fmt::format("{:.4g}: {} of {}", h, count.fallbacks, count.surfels));
    std::vector<std::string> row{shape_text(entry), entry.estimator, radius_text(entry),
                                 fmt::format("{}", fmt::join(steps, ", "))};
    if (noisy) row.insert(row.begin() + 1, fmt::format("{:.3g}", entry.noise));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace gridstep
