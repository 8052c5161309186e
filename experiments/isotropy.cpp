#include "experiments/isotropy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace gridstep {

namespace {

/// A truth that was rotated back differs in the last digits, which must not count on shapes that look alike from all sides.
constexpr double kRounding = 1e-9;

/// @param errors at least one
Isotropy::Spread spread(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  const std::size_t n = errors.size();
  return {errors.front(), (errors[(n - 1) / 2] + errors[n / 2]) / 2, errors.back()};
}

/// The levels at the finest step that both have; nothing where there is none.
std::optional<std::pair<const Level*, const Level*>> finest_of_both(const Convergence& a,
                                                                    const Convergence& b) {
  for (auto level = a.levels.rbegin(); level != a.levels.rend(); ++level)
    for (const Level& other : b.levels)
      if (other.h == level->h) return std::pair{&*level, &other};
  return std::nullopt;
}

}  // namespace

std::vector<Isotropy> isotropies_of(const std::vector<Convergence>& series) {
  std::vector<Isotropy> result;
  for (const Convergence& fixed : series) {
    if (fixed.rotated) continue;
    Setting wanted = fixed;
    wanted.rotated = true;
    for (const Convergence& other : series) {
      if (wanted != static_cast<const Setting&>(other) || other.quantity != fixed.quantity ||
          other.norm != fixed.norm)
        continue;
      const auto levels = finest_of_both(fixed, other);
      if (!levels) continue;
      const auto& [still, turning] = *levels;
      Isotropy entry{fixed,    fixed.quantity,        fixed.norm,
                     still->h, spread(still->errors), spread(turning->errors),
                     0,        turning->errors.size()};
      entry.within =
          std::size_t(std::count_if(turning->errors.begin(), turning->errors.end(), [&](double error) {
            return entry.shifted.least * (1 - kRounding) <= error &&
                   error <= entry.shifted.greatest * (1 + kRounding);
          }));
      result.push_back(std::move(entry));
    }
  }
  return result;
}

Table isotropy_table(const std::vector<Isotropy>& entries) {
  const auto left = Align::left;
  Table table{"Isotropy: least, median and greatest error over shifts, and over shifts with rotations",
              {{"shape", left},
               {"estimator", left},
               {"R", left},
               {"quantity", left},
               {"norm", left},
               {"h"},
               {"shifted"},
               {"median"},
               {"greatest"},
               {"rotated"},
               {"median"},
               {"greatest"},
               {"medians"},
               {"within"}},
              {}};
  for (const Isotropy& entry : entries)
    table.rows.push_back(
        {entry.shape, entry.estimator, radius_text(entry), entry.quantity, entry.norm,
         fmt::format("{:.4g}", entry.h), fmt::format("{:.4g}", entry.shifted.least),
         fmt::format("{:.4g}", entry.shifted.median), fmt::format("{:.4g}", entry.shifted.greatest),
         fmt::format("{:.4g}", entry.turned.least), fmt::format("{:.4g}", entry.turned.median),
         fmt::format("{:.4g}", entry.turned.greatest),
         entry.shifted.median > 0 ? fmt::format("{:.2f}x", entry.turned.median / entry.shifted.median) : "-",
         fmt::format("{} of {}", entry.within, entry.rotations)});
  return table;
}

}  // namespace gridstep
