#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "estimators/integral_invariant/curvature.hpp"

namespace gridstep {

/// The curvature measures of a corrected normal current: a surface x with a field u of vectors in place of its normals
/// [Lachaud, Romon, Thibert, Coeurjolly, CGF 39(5), 2020; Lachaud, Romon, Thibert, DCG 68, 2022]. Over a
/// parametrization by (s, t), with x_s × x_t on the outer side,
///   mu0 = ∫∫ det(u, x_s, x_t)                          the area, where u is the unit normal
///   mu1 = ∫∫ det(u, u_s, x_t) + det(u, x_s, u_t)       twice the integral of the mean curvature
///   mu2 = ∫∫ det(u, u_s, u_t)                          the integral of the Gaussian curvature
///   M   = ∫∫ u_s (x_t × u)' + u_t (u × x_s)'           for tangent X, Y, Y'MX integrates the second fundamental form
/// and mu1 = trace M. Curvature is positive where the surface is convex.
struct CurvatureMeasures {
  double mu0 = 0, mu2 = 0;
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();

  double mu1() const { return M.trace(); }
  CurvatureMeasures& operator+=(const CurvatureMeasures& other);
};

/// Of the parallelogram with edges a and b at its first corner, a × b outwards, and u bilinear between its values at the
/// corners in the order 0, a, a + b, b. Exact, whatever the lengths of the u.
CurvatureMeasures measures_of_bilinear(const std::array<Eigen::Vector3d, 4>& u, const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b);

/// M of an edge, along which u turns from its unit value on the right to that on the left (seen from outside, walking
/// along the edge) by the shorter arc. 0 where the two are opposite: then there is no such arc.
Eigen::Matrix3d second_measure_of_edge(const Eigen::Vector3d& right, const Eigen::Vector3d& left,
                                       const Eigen::Vector3d& edge);

/// mu2 of a vertex: the area, with sign, of the spherical polygon of the unit vectors around it, counterclockwise seen
/// from outside.
double area_on_sphere(std::span<const Eigen::Vector3d> u);

/// The mean curvature of measures, mu1 / (2 mu0), their Gaussian curvature, mu2 / mu0, and the eigenvalues of
/// M / mu0, made symmetric, in the plane orthogonal to a unit vector. All 0 where mu0 is.
struct MeasuredCurvature {
  double mean, gaussian;
  PrincipalCurvatures principal;
};
MeasuredCurvature curvature_of(const CurvatureMeasures& measures, const Eigen::Vector3d& normal);

}  // namespace gridstep
