#pragma once

#include <vector>

#include "estimators/surface/ball_walk.hpp"
#include "estimators/surface/curvature_measures.hpp"
#include "shapes/digital/surfel_corners.hpp"

namespace gridstep {

/// Corrected normals constant on each face: the area is on faces, mu1 and M on edges, mu2 on vertices. So that each cell
/// of the surface counts once, a face has half of an edge, and of a vertex a share with each face around. A cell's
/// faces are all visited where it is in the ball itself. [Lachaud, Romon, Thibert, DCG 68, 2022]
class ConstantCurrent {
 public:
  ConstantCurrent(const QuadSurface& surface, std::vector<Eigen::Vector3d> normals)
      : surface_(surface), normals_(std::move(normals)), mu2_(surface.vertex_count(), 0.0) {
    std::vector<std::uint32_t> ring;
    std::vector<Eigen::Vector3d> around;
    std::vector<bool> done(surface.vertex_count(), false);
    for (std::uint32_t f = 0; f < normals_.size(); ++f)
      for (int i = 0; i < 4; ++i) {
        const std::uint32_t vertex = surface.vertices(f)[std::size_t(i)];
        if (done[vertex]) continue;
        done[vertex] = true;
        surface.ring(f, i, ring);
        around.clear();
        for (auto face = ring.rbegin(); face != ring.rend(); ++face) around.push_back(normals_[*face]);
        mu2_[vertex] = area_on_sphere(around) / double(ring.size());
      }
  }

  const Eigen::Vector3d& normal(std::uint32_t face) const { return normals_[face]; }

  CurvatureMeasures in_ball(std::uint32_t face, const LatticePoint<3>& centre, double radius) const {
    const Surfel<3>& surfel = surface_.faces()[face];
    const auto around = corners(surfel);
    CurvatureMeasures part;
    part.mu0 = inclusion(surfel.cell(), centre, radius) * surfel.sign * normals_[face][surfel.axis];
    for (std::size_t i = 0; i < 4; ++i) {
      const LatticePoint<3>&from = around[i], &to = around[(i + 1) % 4];
      const Eigen::Vector3d edge = (to - from).cast<double>() / 2;
      if (const double in = inclusion(Cell<3>{(from + to) / 2}, centre, radius); in > 0)
        part.M +=
            in / 2 * second_measure_of_edge(normals_[surface_.neighbours(face)[i]], normals_[face], edge);
      part.mu2 += inclusion(Cell<3>{from}, centre, radius) * mu2_[surface_.vertices(face)[i]];
    }
    return part;
  }

 private:
  const QuadSurface& surface_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<double> mu2_;  // of a vertex, the share of each face around
};

}  // namespace gridstep
