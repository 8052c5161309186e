#pragma once

#include <vector>

#include "estimators/surface/ball_walk.hpp"
#include "estimators/surface/curvature_measures.hpp"
#include "shapes/digital/surfel_corners.hpp"

namespace gridstep {

/// Corrected normals at vertices, the normalised means of those of the faces around, and bilinear on each face: all
/// measures are on faces. [Lachaud, Romon, Thibert, Coeurjolly, CGF 39(5), 2020]
class InterpolatedCurrent {
 public:
  InterpolatedCurrent(const QuadSurface& surface, std::vector<Eigen::Vector3d> normals)
      : surface_(surface), normals_(std::move(normals)), measures_(normals_.size()) {
    std::vector<Eigen::Vector3d> at_vertices(surface.vertex_count(), Eigen::Vector3d::Zero());
    for (std::uint32_t f = 0; f < normals_.size(); ++f)
      for (const std::uint32_t vertex : surface.vertices(f)) at_vertices[vertex] += normals_[f];
    for (Eigen::Vector3d& normal : at_vertices) normal.normalize();  // a zero stays zero
    for (std::uint32_t f = 0; f < normals_.size(); ++f) {
      std::array<Eigen::Vector3d, 4> u;
      for (std::size_t i = 0; i < 4; ++i) u[i] = at_vertices[surface.vertices(f)[i]];
      const auto around = corners(surface.faces()[f]);
      const auto edge = [&](std::size_t to) {
        return Eigen::Vector3d((around[to] - around[0]).cast<double>() / 2);
      };
      measures_[f] = measures_of_bilinear(u, edge(1), edge(3));
    }
  }

  const Eigen::Vector3d& normal(std::uint32_t face) const { return normals_[face]; }

  CurvatureMeasures in_ball(std::uint32_t face, const LatticePoint<3>& centre, double radius) const {
    const double in = inclusion(surface_.faces()[face].cell(), centre, radius);
    CurvatureMeasures part = measures_[face];
    part.mu0 *= in;
    part.mu2 *= in;
    part.M *= in;
    return part;
  }

 private:
  const QuadSurface& surface_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<CurvatureMeasures> measures_;
};

}  // namespace gridstep
