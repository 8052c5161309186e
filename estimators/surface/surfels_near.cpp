#include "estimators/surface/surfels_near.hpp"

#include <algorithm>
#include <cmath>

#include "shapes/digital/boundary.hpp"

namespace gridstep {

namespace {

/// The bricks of some surfels, and all bricks at most `margin` away in each direction. In raster order.
std::vector<LatticePoint<3>> bricks_around(std::span<const Surfel<3>> surfels, int margin) {
  std::vector<LatticePoint<3>> bricks;
  const auto sort_out = [&] {
    std::sort(bricks.begin(), bricks.end(), raster_less<3>);
    bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
  };
  for (const Surfel<3>& surfel : surfels)
    if (const LatticePoint<3> brick = Brick<3>::of(surfel.inner); bricks.empty() || bricks.back() != brick)
      bricks.push_back(brick);
  sort_out();
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0, n = bricks.size(); i < n; ++i)
      for (int step = -margin; step <= margin; ++step) {
        LatticePoint<3> brick = bricks[i];
        brick[axis] += step;
        if (step != 0) bricks.push_back(brick);
      }
    sort_out();
  }
  return bricks;
}

}  // namespace

std::vector<Surfel<3>> surfels_near(const DigitalSet<3>& set, std::span<const Surfel<3>> surfels,
                                    DigitalLength reach) {
  const std::vector<LatticePoint<3>> bricks =
      bricks_around(surfels, int(std::ceil(reach.value / Brick<3>::extent(0))));
  constexpr std::size_t kChunk = std::size_t{1} << 16;
  std::vector<Surfel<3>> result;
  for_each_boundary_chunk<3>(set, kChunk, [&](std::span<const Surfel<3>> chunk) {
    LatticePoint<3> last = Brick<3>::of(chunk.front().inner);
    const auto taken = [&] { return std::binary_search(bricks.begin(), bricks.end(), last, raster_less<3>); };
    bool take = taken();
    for (const Surfel<3>& surfel : chunk) {
      if (const LatticePoint<3> brick = Brick<3>::of(surfel.inner); brick != last) {
        last = brick;
        take = taken();
      }
      if (take) result.push_back(surfel);
    }
  });
  return result;
}

}  // namespace gridstep
