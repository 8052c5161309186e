#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "estimators/integral_invariant/convolution.hpp"
#include "estimators/integral_invariant/disk_count.hpp"
#include "estimators/integral_invariant/radial/radial_sum.hpp"
#include "estimators/integral_invariant/radial/radial_weights.hpp"

namespace gridstep {

/// The sums of radial kernels in 2D around linels orthogonal to one axis, row by row: a run of points is a difference of
/// two prefix sums of weights. O(R/h) for each linel, O((R/h)^2) for the tables.
class RadialRows {
 public:
  static constexpr double kGreatestRadius = 4096;

  /// @throws InputError where R/h is above kGreatestRadius: the tables would need more than 2 GiB.
  RadialRows(const RadialWeights& weights, DigitalLength radius, int half_axis);

  /// One sum for each point, the lower spel of its linel. Runs on all threads of the current arena. In `work`,
  /// cells_visited are the runs.
  std::vector<RadialSum> eval(const RowRuns& rows, std::span<const LatticePoint<2>> points,
                              EvaluationWork* work) const;

 private:
  struct Prefix {
    std::int64_t trace, edge;
  };
  int reach_;
  std::vector<int> half_width_;  // of row y + reach: the greatest |x|, or -1
  std::vector<Prefix> prefix_;   // row by row, of the points before x + reach
};

}  // namespace gridstep
