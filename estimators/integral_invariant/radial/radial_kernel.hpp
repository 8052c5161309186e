#pragma once

#include <span>
#include <vector>

namespace gridstep {

/// A radial kernel functor on the unit ball, g(x) = (1 - t)^p (c_0 + c_1 t + c_2 t^2 + ...) with t = |x|^2 <= 1.
///
/// Over the part of the ball below a boundary z = delta - (k1 u^2 + k2 v^2) / 2 + ..., the integral of g depends on
/// delta, how far the ball's centre is from the boundary, through the moment of order 0 of g over the disc z = 0; on
/// curvature through that of order 2; on derivatives of curvature through those of order 4, 6, ... A kernel whose
/// unwanted moments vanish does not see them: what a kernel of higher order is to density estimation. README.md beside this
/// file has the derivation.
struct RadialKernel {
  int edge_power = 0;                ///< p: how smoothly g ends at the ball's boundary
  std::vector<double> coefficients;  ///< c_0, c_1, ...

  double operator()(double t) const;
  /// Integral of t^a g over 0 <= t <= 1, a > -1, as a sum of Beta functions.
  double integral(double a) const;
  /// Integral of |x|^order g over the unit ball of a dimension: 1 (an interval), 2 (a disc) or 3.
  double moment(int dimension, int order) const;
  /// Integral of dg/dt over the unit ball of a dimension.
  double slope_integral(int dimension) const;
};

/// The kernel with c_0 = 1 of the lowest degree whose moments of the given orders over the (d-1)-disc vanish.
///   vanishing_kernel(3, 1, {0})     (1 - t)(1 - 3 t)
///   vanishing_kernel(3, 1, {0, 4})  (1 - t)(1 - 7 t + 8 t^2)
///   vanishing_kernel(2, 1, {0, 4})  (1 - t)(1 - 58/5 t + 77/5 t^2)
/// @throws InputError where d is not 2 or 3, p is not in 0 to 8, or the orders are not even, distinct, at least 0 and at
///         most 6 of them.
RadialKernel vanishing_kernel(int d, int edge_power, std::span<const int> orders);

}  // namespace gridstep
