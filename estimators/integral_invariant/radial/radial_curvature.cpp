#include "estimators/integral_invariant/radial/radial_curvature.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gridstep {

namespace {

/// Of the fixed point that takes off the second order; each one gains a factor of delta kappa.
constexpr int kSteps = 4;

/// A surfel is closer to the boundary than half of R, but where there is no smooth boundary at all.
double within_half(double delta) {
  return std::clamp(delta, -0.5, 0.5);
}

}  // namespace

RadialCurvature::RadialCurvature(const RadialKernels& kernels) {
  const auto over = [&](int dimension) {
    return Moments{kernels.trace.moment(dimension, 2),     kernels.trace.slope_integral(dimension),
                   kernels.edge.moment(dimension, 0),      kernels.edge.moment(dimension, 2),
                   kernels.edge.slope_integral(dimension), kernels.tensor.moment(dimension, 4)};
  };
  line_ = over(1);
  disc_ = over(2);
}

double RadialCurvature::in_2d(double trace, double edge) const {
  const double first = -2 * trace / line_.trace_2;
  // Where the set is no smooth boundary at all, a correction must not outgrow what it corrects.
  const double most = 0.5 * std::abs(first);
  double kappa = first, delta = 0;
  for (int step = 0; step < kSteps; ++step) {
    const double cube = delta * delta * delta / 3;
    delta = within_half((edge + kappa * line_.edge_2 / 2 - cube * line_.edge_slope) / line_.edge_0);
    kappa = first - std::clamp(0.75 * delta * kappa * kappa, -most, most) +
            2 * cube * line_.trace_slope / line_.trace_2;
  }
  return kappa;
}

PrincipalCurvatures RadialCurvature::in_3d(double trace, double edge, const Eigen::Vector3d& edge_first,
                                           const Eigen::Matrix3d& tensor,
                                           const Eigen::Vector3d& fallback_normal) const {
  PrincipalCurvatures result;
  result.normal = edge_first.isZero(0) ? fallback_normal : Eigen::Vector3d(-edge_first.normalized());
  const Eigen::Vector3d u = result.normal.unitOrthogonal(), v = result.normal.cross(u);
  const double scale = -8 / disc_.tensor_4;
  // The deviator's components, and its angle from u to the first direction.
  const double across = scale * (u.dot(tensor * u) - v.dot(tensor * v)) / 2,
               along = scale * u.dot(tensor * v);
  const double angle = std::atan2(along, across) / 2;
  result.dir1 = std::cos(angle) * u + std::sin(angle) * v;
  result.dir2 = result.normal.cross(result.dir1);

  const double first_t = -4 * trace / disc_.trace_2, first_s = std::hypot(across, along);
  const double most = 0.5 * std::abs(first_t) + 0.2 * first_s;
  double t = first_t, s = first_s, delta = 0;
  for (int step = 0; step < kSteps; ++step) {
    const double cube = delta * delta * delta / 3;
    delta = within_half((edge + t * disc_.edge_2 / 4 - cube * disc_.edge_slope) / disc_.edge_0);
    const double squares = t * t / 2 + 2 * s * s;  // k1^2 + k2^2
    const double factor = std::clamp(1 + 1.5 * delta * t, 0.5, 2.0);
    t = first_t - std::clamp(delta * (2 * squares + t * t) / 4, -most, most) +
        4 * cube * disc_.trace_slope / disc_.trace_2;
    s = first_s / factor;
  }
  result.k1 = t / 2 + s;
  result.k2 = t / 2 - s;
  return result;
}

}  // namespace gridstep
