#pragma once

#include <string>
#include <vector>

#include "experiments/analysis.hpp"

namespace gridstep {

/// The errors of one estimator on digitizations alike in all but their noise, at the finest step.
struct NoiseErrors : Setting {  ///< noise is 0
  struct At {
    double beta;
    double error;  ///< mean over the shifts
    Verdict verdict;
  };
  std::string quantity, norm;
  double h;
  std::vector<At> levels;  ///< by beta
};

/// One entry for each series that comes with several levels of noise, in the order of the series.
std::vector<NoiseErrors> noise_errors_of(const std::vector<Convergence>& series);

/// One row an entry, one column a beta. An error that does not fall as h does is marked with "*": that estimator cannot
/// take this noise; one of which the steps do not tell with "?".
Table noise_table(const std::vector<NoiseErrors>& entries);

}  // namespace gridstep
