#pragma once

#include <complex>
#include <span>
#include <vector>

#include "estimators/contour/dft.hpp"
#include "estimators/contour/digital_contour.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// The cyclic convolution of a closed sequence z with the binomial mask of 2n + 1 taps, and its differences:
///   s(i) = sum over |k| <= n of C(2n, n + k) / 4^n z(i - k),
/// where the mask wraps around sequences shorter than itself. Points of the plane are complex numbers.
///   Method  by the mask's transfer function cos^2n(pi k / N), in closed form for any n.
///   Error   about 1e-15 of the largest |z|, scaled by the mask as the sequence is: put z near the origin.
///   Cost    O(N log N) for any N and n: at the construction, and for each difference.
///   Source  [Malgouyres, Brunet, Fourey, DGCI 2008]; in bc.cpp with its title.
class BinomialConvolution {
 public:
  /// @param n a whole number; a double, as it grows without bound where the grid step gets small.
  /// @throws ContractViolation unless n >= 1 and the sequence is not empty.
  BinomialConvolution(std::span<const std::complex<double>> z, double n);

  /// Backward differences of s: s(i), s(i) - s(i-1), s(i) - 2 s(i-1) + s(i-2), and so on.
  std::vector<std::complex<double>> difference(int order);

 private:
  DiscreteFourierTransform transform_;
  std::vector<std::complex<double>> spectrum_;  // of s
};

/// n = ceil(d / h^1/3) with d the contour's diameter in cells: the longer side of its bounding box. Grows
/// like h^-4/3, as published for noise of about one cell.
double binomial_mask_size(const DigitalContour& contour, GridStep h);

}  // namespace gridstep
