#pragma once

#include <array>

#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// The corners of a surfel, its pointels in Khalimsky coordinates, counterclockwise seen from outside.
inline std::array<LatticePoint<3>, 4> corners(const Surfel<3>& surfel) {
  constexpr int around[4][2] = {{-1, -1}, {+1, -1}, {+1, +1}, {-1, +1}};
  const int u = (surfel.axis + 1) % 3, v = (surfel.axis + 2) % 3;  // u x v points along the axis
  std::array<LatticePoint<3>, 4> result;
  for (int i = 0; i < 4; ++i) {
    const int* const step = around[surfel.sign > 0 ? i : 3 - i];
    LatticePoint<3>& corner = result[std::size_t(i)] = surfel.cell().coordinates;
    corner[u] += step[0];
    corner[v] += step[1];
  }
  return result;
}

}  // namespace gridstep
