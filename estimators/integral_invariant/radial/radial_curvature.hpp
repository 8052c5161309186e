#pragma once

#include "estimators/integral_invariant/curvature.hpp"
#include "estimators/integral_invariant/radial/radial_weights.hpp"

namespace gridstep {

/// From integrals of radial kernels over the part of a shape that lies in the ball around a point c near its boundary to
/// curvature at the point of the boundary that is closest to c.
///
/// All is in units of R: integrals are those over the unit ball, less what a half-space through c has, and curvatures come
/// out as kappa R. The shape is the part below z = delta - (k1 u^2 + k2 v^2) / 2, z along the normal. Integrals over it are
/// to first order ones over the disc z = 0, of |x|^n times the kernel: M_n. What the kernel's own expansion, g' z^3 / 3,
/// adds with delta is taken off: delta^3 S / 3, S the integral of g' over the disc, and terms in delta times squares of
/// curvatures, which by partial integration have the same moments.
class RadialCurvature {
 public:
  explicit RadialCurvature(const RadialKernels& kernels);

  /// 2D. With M_0 = 0 for the trace kernel,
  ///   trace = -M_2 kappa (1 + 3/4 delta kappa) / 2,   edge = M_0 delta - M_2 kappa / 2.
  double in_2d(double trace, double edge) const;

  /// 3D. With M_0 = 0 for the trace kernel, t = k1 + k2, s = (k1 - k2) / 2, and the second moment of the tensor kernel,
  ///   trace = -M_2 (t + delta (2 k1^2 + 2 k2^2 + t^2) / 4) / 4,   edge = M_0 delta - M_2 t / 4,
  ///   tensor's deviator in the tangent plane = -M_4 s (1 + 3/2 delta t) / 8 times that of diag(1, -1).
  /// @param edge_first integral of the edge kernel times x: normal to the boundary, it points inwards
  /// @param fallback_normal taken where edge_first is zero
  PrincipalCurvatures in_3d(double trace, double edge, const Eigen::Vector3d& edge_first,
                            const Eigen::Matrix3d& tensor, const Eigen::Vector3d& fallback_normal) const;

  /// 3D, (k1 + k2) / 2 from two integrals alone: s is taken for zero, which leaves delta s^2 in the result.
  double mean_in_3d(double trace, double edge) const;

 private:
  struct Moments {
    double trace_2, trace_slope, edge_0, edge_2, edge_slope, tensor_4;
  };
  /// What the trace kernel sees, -M_2 / n times the curvature, without the distance delta that the edge kernel sees. `gain`
  /// is what delta adds to second order: gain(curvature to first order, curvature so far, delta).
  template <class Gain>
  static double without_distance(const Moments& moments, double n, double trace, double edge, Gain gain);

  Moments line_, disc_;
};

}  // namespace gridstep
