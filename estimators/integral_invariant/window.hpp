#pragma once

#include <cstddef>

#include "shapes/base/lattice.hpp"

namespace gridstep {

/// The extents of a dense window of the lattice; positions in it are raster-ordered.
template <int d>
struct WindowLayout {
  LatticePoint<d> extent;

  /// The position of a point relative to that of another: linear, whatever the signs.
  std::ptrdiff_t distance(const LatticePoint<d>& z) const {
    std::ptrdiff_t result = 0;
    for (int k = d - 1; k >= 0; --k) result = result * extent[k] + z[k];
    return result;
  }
  double volume() const { return extent.template cast<double>().prod(); }
};

}  // namespace gridstep
