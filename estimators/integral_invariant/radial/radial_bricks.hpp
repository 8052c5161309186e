#pragma once

// The sums of radial kernels in 3D as fluxes through surfels.
//
// A sum over the set is, line by line along x, a sum over the places where the line enters the set less one over those where it
// leaves it, of the kernel summed up from there to the ball's end (FluxTables): the divergence theorem, for a field along x. What
// is added up is one entry of a table for each surfel in the ball that is orthogonal to x, O((R/h)^2), in integers.
//
// Lines that are in the set before the ball begins are a plane set, whose sum is in the same way one over its linels.
//
// As for balls (bricks/ball_sums.hpp), surfels are grouped by the brick that they lie in, and what lies around it is listed once
// for all of them (LineEnds).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "estimators/integral_invariant/convolution.hpp"
#include "estimators/integral_invariant/radial/flux_tables.hpp"
#include "estimators/integral_invariant/radial/radial_sum.hpp"
#include "shapes/digital/digital_set.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// Flux: WholeFlux, or CurvatureFlux, which leaves all sums zero but those of the trace and the edge kernel.
template <class Flux>
class RadialBricks {
 public:
  static constexpr double kGreatestRadius = 100;

  /// @throws InputError where R/h is above kGreatestRadius: the tables would need more than 1.7 GiB.
  RadialBricks(const RadialWeights& weights, DigitalLength radius);

  /// One sum for each surfel. Runs on all threads of the current arena. In `work`, cells_visited are the surfels whose
  /// entries were added up.
  std::vector<RadialSum> eval(const DigitalSet<3>& set, std::span<const Surfel<3>> surfels,
                              EvaluationWork& work) const;

 private:
  std::array<FluxTables<Flux>, 3> tables_;  // by the axis of the surfel
};

extern template class RadialBricks<CurvatureFlux>;
extern template class RadialBricks<WholeFlux>;

}  // namespace gridstep
