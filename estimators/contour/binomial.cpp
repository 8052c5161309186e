#include "estimators/contour/binomial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gridstep {

BinomialConvolution::BinomialConvolution(std::span<const std::complex<double>> z, double n)
    : transform_(z.size()), spectrum_(transform_.forward(z)) {
  expects(n >= 1, "a mask size of at least 1");
  for (std::size_t k = 0; k < spectrum_.size(); ++k) {
    // From 1 - sin^2 rather than from the cosine: its rounding error would be multiplied by n.
    const double sine = std::sin(std::numbers::pi * double(k) / double(spectrum_.size()));
    spectrum_[k] *= std::exp(n * std::log1p(-sine * sine));
  }
}

std::vector<std::complex<double>> BinomialConvolution::difference(int order) {
  expects(order >= 0, "a non-negative order");
  std::vector<std::complex<double>> product = spectrum_;
  for (std::size_t k = 0; k < product.size(); ++k) {
    // 1 - exp(-2 i t) = 2 i sin t exp(-i t), without the cancellation at small t.
    const double t = std::numbers::pi * double(k) / double(product.size());
    const std::complex<double> factor = 2 * std::sin(t) * std::complex<double>(std::sin(t), std::cos(t));
    for (int times = 0; times < order; ++times) product[k] *= factor;
  }
  return transform_.inverse(product);
}

double binomial_mask_size(const DigitalContour& contour, GridStep h) {
  LatticePoint<2> lo = contour[0], hi = lo;
  for (const LatticePoint<2>& pointel : contour.pointels) {
    lo = lo.cwiseMin(pointel);
    hi = hi.cwiseMax(pointel);
  }
  return std::ceil(double((hi - lo).maxCoeff()) / std::pow(h.value, 1.0 / 3.0));
}

}  // namespace gridstep
