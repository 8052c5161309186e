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
  /// Keeps the reference.
  ConstantCurrent(const QuadSurface& surface, std::vector<Eigen::Vector3d> normals)
      : surface_(surface),
        normals_(std::move(normals)),
        edges_of_(normals_.size()),
        mu2_(surface.vertex_count()) {
    for (std::uint32_t f = 0; f < normals_.size(); ++f) add_edges(f);
    std::vector<bool> done(surface.vertex_count(), false);
    for (std::uint32_t f = 0; f < normals_.size(); ++f)
      for (int i = 0; i < 4; ++i) {
        const std::uint32_t vertex = surface.vertices(f)[std::size_t(i)];
        if (!done[vertex]) mu2_[vertex] = share_of_vertex(f, i);
        done[vertex] = true;
      }
  }

  const Eigen::Vector3d& normal(std::uint32_t face) const { return normals_[face]; }

  CurvatureMeasures in_ball(std::uint32_t face, const LatticePoint<3>& centre, double radius) const {
    const Surfel<3>& surfel = surface_.faces()[face];
    const auto around = corners(surfel);
    CurvatureMeasures part;
    part.mu0 = inclusion(surfel.cell(), centre, radius) * surfel.sign * normals_[face][surfel.axis];
    for (std::size_t i = 0; i < 4; ++i) {
      const Cell<3> edge{(around[i] + around[(i + 1) % 4]) / 2};
      part.M += inclusion(edge, centre, radius) * edges_[edges_of_[face][i]];
      part.mu2 += inclusion(Cell<3>{around[i]}, centre, radius) * mu2_[surface_.vertices(face)[i]];
    }
    return part;
  }

 private:
  /// Those of a face that no face before it has.
  void add_edges(std::uint32_t face) {
    const auto around = corners(surface_.faces()[face]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t other = surface_.neighbours(face)[i];
      if (other < face) {
        const auto& back = surface_.neighbours(other);
        edges_of_[face][i] =
            edges_of_[other][std::size_t(std::find(back.begin(), back.end(), face) - back.begin())];
        continue;
      }
      edges_of_[face][i] = std::uint32_t(edges_.size());
      edges_.push_back(Eigen::Matrix3d::Zero());
      if (other == QuadSurface::kNone) continue;  // at the rim, where no ball reaches
      const Eigen::Vector3d edge = (around[(i + 1) % 4] - around[i]).cast<double>() / 2;
      edges_.back() = second_measure_of_edge(normals_[other], normals_[face], edge) / 2;
    }
  }

  double share_of_vertex(std::uint32_t face, int corner) const {
    std::vector<std::uint32_t> ring;
    std::vector<Eigen::Vector3d> around;
    surface_.ring(face, corner, ring);
    for (auto other = ring.rbegin(); other != ring.rend(); ++other) around.push_back(normals_[*other]);
    return area_on_sphere(around) / double(ring.size());
  }

  const QuadSurface& surface_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<std::array<std::uint32_t, 4>> edges_of_;  // of a face, its edges
  std::vector<Eigen::Matrix3d> edges_;  // of an edge, the half of M that each of its faces has
  std::vector<double> mu2_;             // of a vertex, the share of each face around
};

}  // namespace gridstep
