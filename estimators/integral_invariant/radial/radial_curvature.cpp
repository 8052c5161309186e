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

template <class Gain>
double RadialCurvature::without_distance(const Moments& moments, double n, double trace, double edge,
                                         Gain gain) {
  const double first = -n * trace / moments.trace_2;
  double curvature = first, delta = 0;
  for (int step = 0; step < kSteps; ++step) {
    const double cube = delta * delta * delta / 3;
    delta = within_half((edge + curvature * moments.edge_2 / n - cube * moments.edge_slope) / moments.edge_0);
    curvature = first - gain(first, curvature, delta) + n * cube * moments.trace_slope / moments.trace_2;
  }
  return curvature;
}

double RadialCurvature::in_2d(double trace, double edge) const {
  return without_distance(line_, 2, trace, edge, [](double first, double kappa, double delta) {
    // Where the set is no smooth boundary at all, a correction must not outgrow what it corrects.
    const double most = 0.5 * std::abs(first);
    return std::clamp(0.75 * delta * kappa * kappa, -most, most);
  });
}

double RadialCurvature::mean_in_3d(double trace, double edge) const {
  return 0.5 * without_distance(disc_, 4, trace, edge, [](double first, double t, double delta) {
           const double most = 0.5 * std::abs(first);
           return std::clamp(0.5 * delta * t * t, -most, most);
         });
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

  const double first_s = std::hypot(across, along);
  double s = first_s;
  const double t = without_distance(disc_, 4, trace, edge, [&](double first, double sum, double delta) {
    const double most = 0.5 * std::abs(first) + 0.2 * first_s;
    const double squares = sum * sum / 2 + 2 * s * s;  // k1^2 + k2^2
    s = first_s / std::clamp(1 + 1.5 * delta * sum, 0.5, 2.0);
    return std::clamp(delta * (2 * squares + sum * sum) / 4, -most, most);
  });
  result.k1 = t / 2 + s;
  result.k2 = t / 2 - s;
  return result;
}

}  // namespace gridstep
