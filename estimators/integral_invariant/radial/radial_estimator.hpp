#pragma once

#include <string>

#include "estimators/catalogue.hpp"

namespace gridstep {

/// An integral invariant with radial kernels whose moments vanish, as a line of the catalogue.
///
///   2D  kappa
///   3D  mean, gaussian, k1, k2, normal_*, dir1_*, dir2_*, as `ii-covariance`
///
/// The kernel is centred on the surfel, whatever KernelCentre the options ask for, and half of the ball's own sums
/// stands for a half-space: on one whose boundary passes through the surfel's centre all curvatures are zero, exactly.
///   Units  1/length (gaussian: 1/length^2), positive where the set is convex; directions are unit vectors
///   Bound  none proven; see vanishing_kernel() for what the kernels do not see, and radial_curvature.hpp for the formulas
///   Cost   see RadialSums
struct RadialFamily {
  /// Number of vanishing moments: 1 frees curvature from the distance between surfel and boundary, 2 from the derivatives
  /// of curvature in R^2 too, and so on.
  int vanishing;
  double usual_k_2d, usual_k_3d;
};
EstimatorEntry radial_entry(const std::string& name, const std::string& summary, const RadialFamily& family);

}  // namespace gridstep
