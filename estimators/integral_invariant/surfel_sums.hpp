#pragma once

#include <optional>
#include <span>
#include <vector>

#include "estimators/estimator.hpp"
#include "estimators/integral_invariant/convolution.hpp"
#include "estimators/options.hpp"

namespace gridstep {

/// The sums of the ball kernel over a digital set, surfel by surfel: what every integral invariant begins
/// with.
///
/// With KernelCentre::spels a surfel has two sums, at its inner and at its outer spel; with
/// KernelCentre::surfel both are the one sum around its centre, with offsets taken from the lower of its two
/// spels.
template <int d, class Sum>
class SurfelSums {
 public:
  struct Pair {
    Sum inner, outer;
  };

  SurfelSums(const DigitalSet<d>& set, const EstimatorOptions& options) : set_(set), options_(options) {}

  void init(GridStep h, EuclideanLength R);
  std::vector<Pair> eval(std::span<const Surfel<d>> surfels);

  EstimatorWork work() const { return work_; }

 private:
  struct Kernels {
    Kernel<d, std::int64_t> kernel;
    std::optional<DisplacementMasks<d, std::int64_t>> masks;
  };
  std::vector<Sum> convolve_at(const Kernels& kernels, std::span<const LatticePoint<d>> points);

  const DigitalSet<d>& set_;
  EstimatorOptions options_;
  std::vector<Kernels> kernels_;  // one, or one for each axis that a surfel can be orthogonal to
  EstimatorWork work_;
};

}  // namespace gridstep
