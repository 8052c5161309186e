#include "shapes/files/quad_mesh.hpp"

#include <algorithm>
#include <limits>

#include "shapes/base/contracts.hpp"
#include "shapes/digital/surfel_corners.hpp"

namespace gridstep {

QuadMesh quad_mesh(std::span<const Surfel<3>> surfels, GridStep h) {
  std::vector<LatticePoint<3>> pointels;
  pointels.reserve(4 * surfels.size());
  for (const Surfel<3>& surfel : surfels)
    for (const LatticePoint<3>& corner : corners(surfel)) pointels.push_back(corner);
  std::sort(pointels.begin(), pointels.end(), raster_less<3>);
  pointels.erase(std::unique(pointels.begin(), pointels.end()), pointels.end());
  if (pointels.size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
    throw InputError("a surface of more than 2^31 vertices is too large for a mesh");

  QuadMesh mesh;
  mesh.vertices.reserve(pointels.size());
  for (const LatticePoint<3>& p : pointels) {
    const RealPoint<3> position = centre(Cell<3>{p}, h.value);
    mesh.vertices.push_back({position[0], position[1], position[2]});
  }
  mesh.quads.reserve(surfels.size());
  for (const Surfel<3>& surfel : surfels) {
    std::array<std::int32_t, 4>& quad = mesh.quads.emplace_back();
    const auto around = corners(surfel);
    for (std::size_t i = 0; i < 4; ++i)
      quad[i] = std::int32_t(std::lower_bound(pointels.begin(), pointels.end(), around[i], raster_less<3>) -
                             pointels.begin());
  }
  return mesh;
}

}  // namespace gridstep
