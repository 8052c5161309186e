#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/core/slope.hpp"
#include "experiments/core/table.hpp"
#include "experiments/record.hpp"

namespace gridstep {

/// The errors of one quantity in one norm along a schedule, and what they say about convergence.
struct Convergence : Setting {
  std::string quantity, norm;
  std::vector<Level> levels;
  SlopeFit fit;
  std::optional<double> expected;        ///< exponent that a theorem gives, where it gives a positive one
  Verdict verdict = Verdict::undecided;  ///< on `expected`, or without one on convergence at all
};

/// The exponent p of the bound O(h^p) on the sup error of integral invariants with R = k h^alpha: the smaller
/// of alpha, from the O(R) of the continuous invariant, and 1 - 2 alpha, from the O(h / R^2) of digitization
/// and position [Coeurjolly, Lachaud, Levallois, CVIU 2014, theorems 1 to 3]. Nothing where it is not above
/// no_convergence.
std::optional<double> proven_exponent(double alpha);

/// Series in the order of the records, each in the norms sup, rms, mean. At each step, records of the
/// first evaluation alone: the others have the same sums. `seed` is that of the bootstrap.
std::vector<Convergence> convergence_of(const std::vector<Record>& records, std::uint64_t seed);

/// The cost of one way of evaluation along a schedule, as medians over the shifts.
struct Cost : Setting {
  struct Step {
    double h, digital_radius, surfels, seconds_init, seconds_eval, cells_visited, restarts, evaluations,
        fallbacks;
  };
  std::string evaluation;
  std::vector<Step> steps;
};
std::vector<Cost> costs_of(const std::vector<Record>& records);

/// The shape as tables have it: what was digitized under rotations says so.
std::string shape_text(const Setting& setting);
/// The radius as tables have it, "5 h^0.333"; "-" without one.
std::string radius_text(const Setting& setting);

/// Slopes and verdicts, one row a series.
Table convergence_table(const std::vector<Convergence>& series);
/// Times and work at the finest step, growth exponents in h (whole surface) and in R/h (one surfel), and the
/// speed-up over the whole kernel at that step.
Table cost_table(const std::vector<Cost>& costs);

/// Every fit with its scan, pairwise orders and verdict, for other programs.
nlohmann::ordered_json to_json(const std::vector<Convergence>& series);
nlohmann::ordered_json to_json(const std::vector<Cost>& costs);

}  // namespace gridstep
