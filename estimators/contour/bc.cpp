#include <cmath>
#include <limits>

#include "estimators/contour/binomial.hpp"
#include "estimators/contour/contour_estimator.hpp"

namespace gridstep {

namespace {

/// Curvature and tangent of the contour of linel midpoints, smoothed by a binomial mask: with t and c the
/// first and the second backward difference of the smoothed midpoints (complex numbers, in cells),
///   tangent = t / |t|, kappa = Im(conj(t) c) / (h |t|^3).
///   Units       kappa in 1/length, positive where the set is convex; the tangent has length 1 and walks
///               with the set on the left.
///   Mask        binomial_mask_size().
///   Position    the linel's centre, as published. Backward differences lag: t belongs to the linel's
///               starting pointel, c to the centre of the preceding linel. The mask is far wider.
///   Bound       announced O(h^4/9), not observed: the slope of the sup error is 0.11 to 0.16.
///   Degenerate  kappa = 0, and the direction of the linel, where t vanishes: the mask swallows the contour.
///   Cost        O(N log N) for a contour of N linels.
///   Sources     [Malgouyres, Brunet, Fourey, Binomial convolutions and derivatives estimation from noisy
///               discretizations, DGCI 2008], [Esbelin, Malgouyres, Cartade, Convergence of binomial-based
///               derivative estimation for C^2 noisy discretized curves, TCS 412(36), 2011].
void binomial_curvature(const DigitalContour& contour, GridStep h,
                        std::vector<std::vector<double>>& columns) {
  const auto N = std::size_t(contour.size());
  std::vector<std::complex<double>> midpoints(N);
  for (std::size_t i = 0; i < N; ++i) {
    const auto at = std::ptrdiff_t(i);
    // Relative to the first pointel: sets far away from the origin lose no digits.
    const LatticePoint<2> twice = (contour[at] - contour[0]) + (contour[at + 1] - contour[0]);
    midpoints[i] = {0.5 * twice[0], 0.5 * twice[1]};
  }
  BinomialConvolution smoothed(midpoints, binomial_mask_size(contour, h));
  const auto first = smoothed.difference(1), second = smoothed.difference(2);
  for (std::size_t i = 0; i < N; ++i) {
    const double length = std::abs(first[i]);
    // Above this no quotient below overflows.
    const bool vanishes = length < std::cbrt(std::numeric_limits<double>::min());
    const LatticePoint<2> step = contour.step(std::ptrdiff_t(i));
    const std::complex<double> tangent =
        vanishes ? std::complex<double>(step[0], step[1]) : first[i] / length;
    columns[0][i] = vanishes ? 0.0 : (std::conj(tangent) * (second[i] / length)).imag() / length / h.value;
    columns[1][i] = tangent.real();
    columns[2][i] = tangent.imag();
  }
}

}  // namespace

EstimatorEntry describe_bc() {
  return contour_estimator(
      "bc", "binomial convolution of the contour: curvature and tangent (2D)",
      {{"kappa", std::nullopt}, {"tangent_x", std::nullopt}, {"tangent_y", std::nullopt}},
      ValuePosition::surfel_centre, binomial_curvature);
}

}  // namespace gridstep
