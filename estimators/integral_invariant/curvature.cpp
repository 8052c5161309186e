#include "estimators/integral_invariant/curvature.hpp"

#include <Eigen/Eigenvalues>
#include <numbers>

namespace gridstep {

using std::numbers::pi;

double curvature_from_area(double area, EuclideanLength R) {
  return 3 * pi / (2 * R.value) - 3 * area / (R.value * R.value * R.value);
}

double mean_curvature_from_volume(double volume, EuclideanLength R) {
  const double R2 = R.value * R.value;
  return 8 / (3 * R.value) - 4 * volume / (pi * R2 * R2);
}

PrincipalCurvatures principal_curvatures(const Eigen::Matrix3d& J, const Eigen::Vector3d& towards_inside,
                                         EuclideanLength R) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(J);
  const double l1 = eigen.eigenvalues()[2], l2 = eigen.eigenvalues()[1];
  const double R3 = R.value * R.value * R.value;
  const double scale = 6 / (pi * R3 * R3), offset = 8 / (5 * R.value);
  PrincipalCurvatures result;
  result.k2 = scale * (l2 - 3 * l1) + offset;
  result.k1 = scale * (l1 - 3 * l2) + offset;
  result.dir2 = eigen.eigenvectors().col(2);
  result.dir1 = eigen.eigenvectors().col(1);
  result.normal = eigen.eigenvectors().col(0);
  if (result.normal.dot(towards_inside) > 0) result.normal = -result.normal;
  return result;
}

std::array<double, kSurfaceQuantities.size()> surface_values(double mean, double gaussian,
                                                             const PrincipalCurvatures& principal) {
  const auto& [k1, k2, dir1, dir2, normal] = principal;
  return {mean,    gaussian, k1,      k2,      normal[0], normal[1], normal[2],
          dir1[0], dir1[1],  dir1[2], dir2[0], dir2[1],   dir2[2]};
}

}  // namespace gridstep
