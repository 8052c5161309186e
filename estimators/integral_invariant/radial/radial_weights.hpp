#pragma once

#include <compare>
#include <cstdint>

#include "estimators/integral_invariant/radial/radial_kernel.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// The kernels of one estimator, all over the same ball.
struct RadialKernels {
  RadialKernel trace;   ///< for (mean) curvature
  RadialKernel edge;    ///< for the distance of the centre from the boundary; in 3D for the normal too
  RadialKernel tensor;  ///< for the directions of curvature; 3D
};

/// A kernel functor as integer weights: round(2^20 g / max |g|). Every weight is rounded by 2^-21 of the greatest one at
/// most, and then nothing is: sums are exact, whatever the order of the additions.
class RadialWeight {
 public:
  RadialWeight(const RadialKernel& kernel, DigitalLength radius);

  /// At a point of the ball whose squared distance from the centre is given, in half cells.
  std::int64_t operator()(std::int64_t squared) const;
  /// What a weight is to be multiplied by to become g.
  double unit() const { return unit_; }

 private:
  RadialKernel kernel_;
  double squared_diameter_, unit_;
};

/// Weights of the three kernels at one point.
struct RadialTriple {
  std::int64_t trace = 0, edge = 0, tensor = 0;
  friend auto operator<=>(const RadialTriple&, const RadialTriple&) = default;
};

struct RadialWeights {
  RadialWeight trace, edge, tensor;

  RadialWeights(const RadialKernels& kernels, DigitalLength radius)
      : trace(kernels.trace, radius), edge(kernels.edge, radius), tensor(kernels.tensor, radius) {}
  RadialTriple operator()(std::int64_t squared) const {
    return {trace(squared), edge(squared), tensor(squared)};
  }
};

}  // namespace gridstep
