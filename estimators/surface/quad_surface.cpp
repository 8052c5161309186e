#include "estimators/surface/quad_surface.hpp"

#include <algorithm>

#include "estimators/surface/surfels_near.hpp"
#include "shapes/base/parallel.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/surfel_corners.hpp"

namespace gridstep {

namespace {

bool cell_less(const Surfel<3>& a, const Surfel<3>& b) {
  return raster_less<3>(a.cell().coordinates, b.cell().coordinates);
}

/// The surfel behind edge i, which leads from corner i to the next.
Surfel<3> behind_edge(const DigitalSet<3>& set, const Surfel<3>& surfel, int i) {
  const auto around = corners(surfel);
  // In half cells, the middle of the edge is one step off the centre of the surfel.
  const LatticePoint<3> step =
      (around[std::size_t(i)] + around[std::size_t(i + 1) % 4]) / 2 - surfel.cell().coordinates;
  int axis;
  step.cwiseAbs().maxCoeff(&axis);
  return adjacent_surfel(set, surfel, axis, step[axis], SurfelAdjacency::interior);
}

}  // namespace

QuadSurface::QuadSurface(const DigitalSet<3>& set, std::span<const Surfel<3>> surfels, DigitalLength reach) {
  faces_ = surfels_near(set, surfels, reach);
  expects(faces_.size() < kNone, "fewer than 2^32 faces");
  std::sort(faces_.begin(), faces_.end(), cell_less);

  neighbours_.resize(faces_.size());
  parallel_chunks(faces_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f != end; ++f)
      for (int i = 0; i < 4; ++i) neighbours_[f][std::size_t(i)] = find(behind_edge(set, faces_[f], i));
  });

  vertices_.assign(faces_.size(), {kNone, kNone, kNone, kNone});
  std::vector<std::uint32_t> around;
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    for (int i = 0; i < 4; ++i) {
      if (vertices_[f][std::size_t(i)] != kNone) continue;
      const LatticePoint<3> pointel = corners(faces_[f])[std::size_t(i)];
      ring(f, i, around);
      for (const std::uint32_t g : around) {
        const auto of_g = corners(faces_[g]);
        std::uint32_t& vertex =
            vertices_[g][std::size_t(std::find(of_g.begin(), of_g.end(), pointel) - of_g.begin())];
        // At the rim of what was taken, a ring may run into another part of its own.
        if (vertex == kNone) vertex = std::uint32_t(vertex_count_);
      }
      ++vertex_count_;
    }
}

std::uint32_t QuadSurface::find(const Surfel<3>& surfel) const {
  const auto found = std::lower_bound(faces_.begin(), faces_.end(), surfel, cell_less);
  return found != faces_.end() && *found == surfel ? std::uint32_t(found - faces_.begin()) : kNone;
}

std::uint32_t QuadSurface::number_of(const Surfel<3>& surfel) const {
  const std::uint32_t face = find(surfel);
  expects(face != kNone, "a surfel of the boundary");
  return face;
}

void QuadSurface::ring(std::uint32_t face, int corner, std::vector<std::uint32_t>& result) const {
  const LatticePoint<3> pointel = corners(faces_[face])[std::size_t(corner)];
  result.clear();
  std::uint32_t next = face;
  do {
    result.push_back(next);
    // The edge that leaves the pointel in one face arrives there in the next one.
    const auto around = corners(faces_[next]);
    const auto at = std::size_t(std::find(around.begin(), around.end(), pointel) - around.begin());
    next = neighbours_[next][at];
  } while (next != face && next != kNone);
}

}  // namespace gridstep
