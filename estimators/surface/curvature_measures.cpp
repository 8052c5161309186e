#include "estimators/surface/curvature_measures.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

namespace gridstep {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

double det(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return a.dot(b.cross(c));
}

/// [a] with [a] v = a × v.
Matrix3d cross_matrix(const Vector3d& a) {
  Matrix3d result;
  result << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return result;
}

/// The integral over [0, 1] of f g', both linear, f from f0 to f1 and g from g0 to g1.
Matrix3d product_of_linear(const Vector3d& f0, const Vector3d& f1, const Vector3d& g0, const Vector3d& g1) {
  return (f0 * (2 * g0 + g1).transpose() + f1 * (g0 + 2 * g1).transpose()) / 6;
}

}  // namespace

CurvatureMeasures& CurvatureMeasures::operator+=(const CurvatureMeasures& other) {
  mu0 += other.mu0;
  mu2 += other.mu2;
  M += other.M;
  return *this;
}

CurvatureMeasures measures_of_bilinear(const std::array<Vector3d, 4>& u, const Vector3d& a,
                                       const Vector3d& b) {
  CurvatureMeasures result;
  result.mu0 = det((u[0] + u[1] + u[2] + u[3]) / 4, a, b);
  // u_s does not depend on s, nor u_t on t: what is left of the other factor is its mean.
  const Matrix3d us_u = product_of_linear(u[1] - u[0], u[2] - u[3], (u[0] + u[1]) / 2, (u[3] + u[2]) / 2);
  const Matrix3d ut_u = product_of_linear(u[3] - u[0], u[2] - u[1], (u[0] + u[3]) / 2, (u[1] + u[2]) / 2);
  result.M = us_u * cross_matrix(b).transpose() - ut_u * cross_matrix(a).transpose();
  // Three times the volume of the cone over a bilinear patch, which is the mean of both ways to halve it.
  result.mu2 =
      (det(u[0], u[1], u[2]) + det(u[0], u[2], u[3]) + det(u[0], u[1], u[3]) + det(u[1], u[2], u[3])) / 4;
  return result;
}

Matrix3d second_measure_of_edge(const Vector3d& right, const Vector3d& left, const Vector3d& edge) {
  const Vector3d axis = right.cross(left);
  const double sine = axis.norm(), cosine = right.dot(left);
  if (sine == 0) return Matrix3d::Zero();
  // u = cos right + sin ahead; the integral over the arc of u_t u', and (u × edge)' = u' [edge].
  const Vector3d ahead = (axis / sine).cross(right);
  const double angle = std::atan2(sine, cosine);
  const Matrix3d ut_u = (sine * sine * (ahead * ahead.transpose() - right * right.transpose()) +
                         (angle + sine * cosine) * ahead * right.transpose() -
                         (angle - sine * cosine) * right * ahead.transpose()) /
                        2;
  return ut_u * cross_matrix(edge);
}

double area_on_sphere(std::span<const Vector3d> u) {
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& corner : u) middle += corner;
  if (middle.squaredNorm() == 0) return 0;
  middle.normalize();
  double area = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Vector3d& v = u[i];
    const Vector3d& w = u[(i + 1) % u.size()];
    // [van Oosterom & Strackee, 1983]
    area += 2 * std::atan2(det(middle, v, w), 1 + middle.dot(v) + v.dot(w) + w.dot(middle));
  }
  return area;
}

MeasuredCurvature curvature_of(const CurvatureMeasures& measures, const Vector3d& normal) {
  const double scale = measures.mu0 == 0 ? 0 : 1 / measures.mu0;
  Eigen::Matrix<double, 3, 2> tangent;
  tangent.col(0) = normal.unitOrthogonal();
  tangent.col(1) = normal.cross(tangent.col(0));
  const Matrix3d symmetric = scale / 2 * (measures.M + measures.M.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(tangent.transpose() * symmetric * tangent);
  const auto direction = [&](int i) {
    // The sign is not to depend on rounding: no direction of the lattice is orthogonal to this one.
    static const Vector3d positive(1, std::sqrt(2), std::sqrt(3));
    const Vector3d v = tangent * eigen.eigenvectors().col(i);
    return v.dot(positive) < 0 ? Vector3d(-v) : v;
  };
  return {scale / 2 * measures.mu1(),
          scale * measures.mu2,
          {eigen.eigenvalues()[1], eigen.eigenvalues()[0], direction(1), direction(0), normal}};
}

}  // namespace gridstep
