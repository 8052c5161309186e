#pragma once

#include <string>
#include <vector>

#include "experiments/analysis.hpp"

namespace gridstep {

/// The errors of one estimator under shifts alone beside those under as many shifts with a random rotation each: whether
/// an error depends on how the shape lies on the grid. What a shift does is in both.
struct Isotropy : Setting {  ///< rotated is false
  /// Of the errors over the placements.
  struct Spread {
    double least, median, greatest;
  };
  std::string quantity, norm;
  double h;
  Spread shifted, turned;
  /// Rotations whose error lies within [least, greatest] of the shifts, rounding aside, and all of them. Where rotations change nothing,
  /// the expected share is (n - 1) / (n + 1), n the number of shifts.
  std::size_t within, rotations;
};

/// One entry for each series without rotations that also comes with them, at the finest step of both, in the order of the
/// series.
std::vector<Isotropy> isotropies_of(const std::vector<Convergence>& series);

/// One row an entry.
Table isotropy_table(const std::vector<Isotropy>& entries);

}  // namespace gridstep
