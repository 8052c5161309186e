#include "shapes/files/quad_mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "shapes/base/contracts.hpp"
#include "shapes/digital/surfel_corners.hpp"

namespace gridstep {

namespace {

constexpr double kLargestCoordinate = 1 << 27;  // of pointels, so that sums of Khalimsky ones are ints
constexpr double kRounding = 1e-3;  // of a grid step, in coordinates that were written as decimals

/// In Khalimsky coordinates, or nothing where it lies elsewhere.
std::optional<LatticePoint<3>> pointel_at(const std::array<double, 3>& position, GridStep h) {
  LatticePoint<3> p;
  for (int k = 0; k < 3; ++k) {
    const double z = position[std::size_t(k)] / h.value + 0.5, nearest = std::round(z);
    if (!(std::abs(nearest) <= kLargestCoordinate && std::abs(z - nearest) <= kRounding)) return std::nullopt;
    p[k] = 2 * int(nearest);
  }
  return p;
}

/// With these corners in this order, if there is one.
std::optional<Surfel<3>> surfel_between(const std::array<LatticePoint<3>, 4>& p) {
  const LatticePoint<3> right = (p[1] - p[0]) / 2, up = (p[2] - p[1]) / 2;
  if (right.lpNorm<1>() != 1 || up.lpNorm<1>() != 1) return std::nullopt;
  const LatticePoint<3> normal = right.cross(up);
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[axis] == 0) continue;
    const LatticePoint<3> centre = p[0] + right + up;
    const Surfel<3> surfel{digital_point(Cell<3>{centre - normal}), std::int8_t(axis),
                           std::int8_t(normal[axis])};
    if (corners(surfel) == p) return surfel;
  }
  return std::nullopt;
}

}  // namespace

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

std::vector<Surfel<3>> surfels_of(const QuadMesh& mesh, GridStep h) {
  std::vector<std::optional<LatticePoint<3>>> pointels;
  pointels.reserve(mesh.vertices.size());
  for (const auto& vertex : mesh.vertices) pointels.push_back(pointel_at(vertex, h));

  std::vector<Surfel<3>> surfels;
  surfels.reserve(mesh.quads.size());
  for (const auto& quad : mesh.quads) {
    std::array<LatticePoint<3>, 4> around;
    bool on_grid = true;
    for (std::size_t i = 0; i < 4 && on_grid; ++i) {
      const auto& pointel = pointels[std::size_t(quad[i])];
      on_grid = pointel.has_value();
      if (on_grid) around[i] = *pointel;
    }
    const auto surfel = on_grid ? surfel_between(around) : std::nullopt;
    if (!surfel) throw InputError(fmt::format("face {} is no surfel at h = {}", surfels.size(), h.value));
    surfels.push_back(*surfel);
  }
  return surfels;
}

}  // namespace gridstep
