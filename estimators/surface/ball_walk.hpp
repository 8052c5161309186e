#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "estimators/surface/quad_surface.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

/// How much of a vertex, edge or face is in a ball, from the distances of its corners and its centre to the ball's: 1
/// where the largest is at most the radius, 0 where the smallest is at least that, and linear between. This is how the
/// authors of corrected curvature measures count cells (DGtal's SurfaceMesh).
/// @param centre of the ball, in Khalimsky coordinates
/// @param radius in half cells
inline double inclusion(const Cell<3>& cell, const LatticePoint<3>& centre, double radius) {
  double nearest = 0, farthest = 0, middle = 0;
  for (int k = 0; k < 3; ++k) {
    const double distance = std::abs(cell.coordinates[k] - centre[k]), half = cell.open(k);
    nearest += (distance - half) * (distance - half);
    farthest += (distance + half) * (distance + half);
    middle += distance * distance;
  }
  nearest = std::min(nearest, middle);
  if (farthest <= radius * radius) return 1;
  if (nearest >= radius * radius) return 0;
  return (radius - std::sqrt(nearest)) / (std::sqrt(farthest) - std::sqrt(nearest));
}

/// The square of the distance from a point to a closed cell, in half cells.
inline int squared_distance(const Cell<3>& cell, const LatticePoint<3>& point) {
  int sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int distance = std::abs(cell.coordinates[k] - point[k]),
              outside = std::max(0, distance - cell.open(k));
    sum += outside * outside;
  }
  return sum;
}

/// Visits the part of a surface in a ball around a face that is connected to that face there. Of one thread.
class BallWalk {
 public:
  /// Keeps the reference.
  explicit BallWalk(const QuadSurface& surface) : surface_(&surface), seen_(surface.faces().size(), 0) {}

  /// Calls visit(face) for the faces that are less than the radius away, breadth first: an order that depends on the
  /// surface in the ball alone.
  /// @param radius in half cells
  template <class Visit>
  void operator()(std::uint32_t start, double radius, Visit visit) {
    const auto& faces = surface_->faces();
    const LatticePoint<3> centre = faces[start].cell().coordinates;
    if (++round_ == 0) {  // after 2^32 rounds
      std::fill(seen_.begin(), seen_.end(), 0u);
      ++round_;
    }
    queue_.assign(1, start);
    seen_[start] = round_;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const std::uint32_t face = queue_[i];
      if (squared_distance(faces[face].cell(), centre) >= radius * radius) continue;
      for (const std::uint32_t next : surface_->neighbours(face)) {
        expects(next != QuadSurface::kNone, "a surface that reaches as far as the ball");
        if (seen_[next] == round_) continue;
        seen_[next] = round_;
        queue_.push_back(next);
      }
      visit(face);
    }
  }

 private:
  const QuadSurface* surface_;
  std::vector<std::uint32_t> seen_;  // the round that a face was last met in
  std::vector<std::uint32_t> queue_;
  std::uint32_t round_ = 0;
};

}  // namespace gridstep
