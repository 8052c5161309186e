#pragma once

#include <Eigen/Core>
#include <array>

#include "shapes/base/lattice.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

// From the measure of the part of a shape that lies in a ball of radius R to curvature [Pottmann et al., CAGD
// 2009; Coeurjolly, Lachaud, Levallois, CVIU 2014, eqs. (2), (3) and table 1]. Curvature in 1/length,
// positive where the shape is convex.

/// kappa = 3 pi / (2 R) - 3 A / R^3, A the area in the disk. 2D.
double curvature_from_area(double area, EuclideanLength R);

/// H = 8 / (3 R) - 4 V / (pi R^4), V the volume in the ball. 3D.
double mean_curvature_from_volume(double volume, EuclideanLength R);

struct PrincipalCurvatures {
  double k1, k2;               ///< k1 >= k2
  Eigen::Vector3d dir1, dir2;  ///< unit, the principal directions of k1 and of k2, signs arbitrary
  Eigen::Vector3d normal;      ///< unit, oriented away from `towards_inside`
};

/// From J = integral of (p - c)(p - c)' over the part of the shape in the ball, c its centroid; l1 >= l2 >=
/// l3 its eigenvalues, e1, e2, e3 its eigenvectors:
///   along e1  6/(pi R^6) (l2 - 3 l1) + 8/(5 R)   (the smaller one, k2)
///   along e2  6/(pi R^6) (l1 - 3 l2) + 8/(5 R)   (the larger one, k1)
/// and e3 is normal to the surface; towards_inside is any vector on its inner side, such as the first moment.
PrincipalCurvatures principal_curvatures(const Eigen::Matrix3d& J, const Eigen::Vector3d& towards_inside,
                                         EuclideanLength R);

/// The columns of an estimator of all curvatures of a surface, and the values of a row of them. Mean and Gaussian
/// curvature are given apart: some estimators measure them on their own.
inline constexpr std::array<const char*, 13> kSurfaceQuantities{
    "mean",   "gaussian", "k1",     "k2",     "normal_x", "normal_y", "normal_z",
    "dir1_x", "dir1_y",   "dir1_z", "dir2_x", "dir2_y",   "dir2_z"};
std::array<double, kSurfaceQuantities.size()> surface_values(double mean, double gaussian,
                                                             const PrincipalCurvatures& principal);

}  // namespace gridstep
