#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "estimators/estimator.hpp"
#include "estimators/integral_invariant/convolution.hpp"
#include "estimators/integral_invariant/radial/radial_bricks.hpp"
#include "estimators/integral_invariant/radial/radial_rows.hpp"
#include "estimators/options.hpp"

namespace gridstep {

/// The sums of radial kernels over a digital set, surfel by surfel.
///   full    through convolve(): the whole kernel at every surfel, the plain reference
///   bricks  RadialBricks in 3D, O((R/h)^2) for each surfel; RadialRows in 2D, O(R/h)
/// Without a tensor, in 3D and by bricks, only the sums of the trace and the edge kernel are made; the others are zero.
template <int d>
class RadialSums {
 public:
  RadialSums(const DigitalSet<d>& set, const RadialKernels& kernels, Evaluation evaluation,
             bool tensor = true)
      : set_(set), kernels_(kernels), evaluation_(evaluation), tensor_(tensor) {}

  /// @throws InputError where R/h < 1, is not finite, or is above what the strategy has tables for.
  void init(GridStep h, EuclideanLength R);
  std::vector<RadialSum> eval(std::span<const Surfel<d>> surfels);

  /// The sums over the whole ball around a surfel orthogonal to `axis`.
  const RadialSum& whole(int axis) const { return balls_[std::size_t(axis)].whole; }
  const RadialWeights& weights() const { return *weights_; }
  EstimatorWork work() const { return work_; }

 private:
  /// Around surfels orthogonal to one axis.
  struct Ball {
    RadialSum whole;
    Kernel<d, RadialTriple> kernel;  // for `full`
    std::optional<RadialRows> rows;  // 2D, bricks
  };
  std::vector<RadialSum> sums_at(int axis, std::span<const LatticePoint<d>> points, EvaluationWork& work);
  void eval_along(int axis, std::span<const Surfel<d>> surfels, std::span<RadialSum> result,
                  EvaluationWork& work);

  const DigitalSet<d>& set_;
  RadialKernels kernels_;
  Evaluation evaluation_;
  bool tensor_;
  std::optional<RadialWeights> weights_;
  std::vector<Ball> balls_;
  std::variant<std::monostate, RadialBricks<CurvatureFlux>, RadialBricks<WholeFlux>> bricks_;  // 3D, bricks
  std::optional<RowRuns> rows_;                                                                // 2D, bricks
  EstimatorWork work_;
};

}  // namespace gridstep
