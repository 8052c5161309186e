#pragma once

// The sums of radial kernels in 3D, 512 points at a time.
//
// As for balls (bricks/ball_sums.hpp), the points to evaluate at are grouped by the brick S that they lie in, and the
// bricks around S are listed once for all of them: mixed bricks one by one, full ones as runs along x. Weights leave no
// brick of the ball out, and so a point costs O((R/h)^2).
//
//   mixed  The kernels are dense tables of weights. Each of the brick's 64 lines is eight weights of a table, where its
//          byte has a bit: one vector of 32-bit integers. Moments along y and z are running sums, from the last line to
//          the first (Horner): after all lines a_j, those of running sums are  sum a_j,  sum (j + 1) a_j,
//          sum (j + 1)(j + 2) / 2 a_j.
//   full   For each of the 512 places of a point in S there is a table of prefix sums over whole bricks: a run is the
//          difference of two entries.

#include <cstdint>
#include <memory>
#include <vector>

#include "estimators/integral_invariant/bricks/spels_by_brick.hpp"
#include "estimators/integral_invariant/convolution.hpp"
#include "estimators/integral_invariant/radial/radial_sum.hpp"
#include "estimators/integral_invariant/radial/radial_weights.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// Sums around surfels orthogonal to one axis.
class RadialBricks {
 public:
  /// @throws InputError where R/h is above kGreatestRadius: the tables would need more than 1 GiB.
  RadialBricks(const RadialWeights& weights, DigitalLength radius, int half_axis);
  RadialBricks(RadialBricks&&) noexcept;
  ~RadialBricks();

  static constexpr double kGreatestRadius = 100;

  /// One sum for each spel, the lower one of its surfel, in the order of their positions. Runs on all threads of the
  /// current arena. In `work`, cells_visited are the mixed bricks and the runs, summed up over the spels.
  std::vector<RadialSum> eval(const DigitalSet<3>& set, const bricks::SpelsByBrick<3>& spels,
                              EvaluationWork* work) const;

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

}  // namespace gridstep
