#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapes/base/lattice.hpp"

namespace gridstep {

/// The extents of a dense window of the lattice; positions in it are raster-ordered.
template <int d>
struct WindowLayout {
  LatticePoint<d> extent;  ///< extent[0] is a multiple of 8, so that rows of bits begin at bytes

  /// The position of a point relative to that of another: linear, whatever the signs.
  std::ptrdiff_t distance(const LatticePoint<d>& z) const {
    std::ptrdiff_t result = 0;
    for (int k = d - 1; k >= 0; --k) result = result * extent[k] + z[k];
    return result;
  }
  double volume() const { return extent.template cast<double>().prod(); }
};

/// The values of a shape functor over a window, one for each cell.
template <class T>
struct ValueWindow {
  using Value = T;
  std::vector<T> values;

  void resize(std::size_t cells) { values.resize(cells); }
  T operator[](std::ptrdiff_t position) const { return values[std::size_t(position)]; }
};

/// The same for a functor with values 0 and 1, one bit for each cell: eight times less memory to read from is
/// what makes scattered reads fast.
struct BitWindow {
  using Value = std::uint8_t;
  std::vector<std::uint8_t> bytes;

  void resize(std::size_t cells) { bytes.resize(cells / 8); }
  std::uint8_t operator[](std::ptrdiff_t position) const {
    return (bytes[std::size_t(position) >> 3] >> (position & 7)) & 1;
  }
};

}  // namespace gridstep
