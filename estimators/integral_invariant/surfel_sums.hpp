#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "estimators/estimator.hpp"
#include "estimators/integral_invariant/bricks/ball_sums.hpp"
#include "estimators/integral_invariant/convolution.hpp"
#include "estimators/options.hpp"

namespace gridstep {

/// The sums of the ball kernel over a digital set, surfel by surfel: what every integral invariant begins
/// with.
///
/// With KernelCentre::spels a surfel has two sums, at its inner and at its outer spel; with
/// KernelCentre::surfel both are the one sum around its centre, with offsets taken from the lower of its two
/// spels. Evaluation::bricks takes so many surfels at a time that their sums at spels fit 32 MiB; a spel that
/// surfels of two such batches share is evaluated, and counted, twice.
template <int d, class Sum>
class SurfelSums {
 public:
  /// What to do with the sums of the i-th surfel.
  using Use = std::function<void(std::size_t i, const Sum& inner, const Sum& outer)>;

  SurfelSums(const DigitalSet<d>& set, const EstimatorOptions& options) : set_(set), options_(options) {}

  void init(GridStep h, EuclideanLength R);
  /// Calls use() once for each surfel, from all threads of the current arena.
  void eval(std::span<const Surfel<d>> surfels, const Use& use);

  EstimatorWork work() const { return work_; }

 private:
  struct Kernels {
    Kernel<d, std::int64_t> kernel;
    std::optional<DisplacementMasks<d, std::int64_t>> masks;
  };
  void eval_kernels(std::span<const Surfel<d>> surfels, const Use& use);
  std::vector<Sum> convolve_at(const Kernels& kernels, std::span<const LatticePoint<d>> points);
  /// The first surfel's number is `first`.
  void eval_bricks(std::span<const Surfel<d>> surfels, std::size_t first, const Use& use);
  void add_work(const EvaluationWork& work);

  const DigitalSet<d>& set_;
  EstimatorOptions options_;
  // One of the two; one entry, or one for each axis that a surfel can be orthogonal to.
  std::vector<Kernels> kernels_;
  std::vector<bricks::BallSums<d, Sum>> balls_;
  EstimatorWork work_;
};

}  // namespace gridstep
