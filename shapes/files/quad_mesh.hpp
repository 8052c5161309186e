#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// The surfels of a surface as squares between pointels.
struct QuadMesh {
  std::vector<std::array<double, 3>> vertices;  ///< each pointel once, in raster order
  std::vector<std::array<std::int32_t, 4>>
      quads;  ///< quads[i] is surfel i, counterclockwise seen from outside
};

/// Vertices are in the unit of the shape, h/2 off the centres of the spels in each direction. Cost O(n log n).
/// @throws InputError where there are more than 2^31 vertices.
QuadMesh quad_mesh(std::span<const Surfel<3>> surfels, GridStep h);

/// The inverse: the surfels that the squares are. Cost O(n).
/// @throws InputError naming the first square that is none of the grid of step h.
std::vector<Surfel<3>> surfels_of(const QuadMesh& mesh, GridStep h);

}  // namespace gridstep
