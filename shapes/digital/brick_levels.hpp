#pragma once

#include <array>

#include "shapes/digital/brick.hpp"

namespace gridstep {

/// A quadratic function at the points n of a brick, counted from its lowest one:
///   constant + linear . n + sum_{j <= k} square[(j, k)] n_j n_k,
/// the pairs as xx, xy, yy in 2D and xx, xy, xz, yy, yz, zz in 3D.
template <int d>
struct BrickLevels {
  float constant;
  std::array<float, d> linear;
  std::array<float, d*(d + 1) / 2> square;

  /// Where the absolute values of all terms add up to at most 1 at every point of the brick, levels are within this
  /// of the exact ones: a dozen roundings to 24 bits.
  static constexpr float kRounding = 1e-6f;
};

template <int d>
struct ComparedLevels {
  Brick<d> below, above;
};

/// The points whose level is below -within, and those whose level is above `within`. The same on every processor, bit for
/// bit; with the widest vector instructions that it has.
template <int d>
ComparedLevels<d> compare(const BrickLevels<d>& levels, float within);

template <>
ComparedLevels<2> compare(const BrickLevels<2>& levels, float within);
template <>
ComparedLevels<3> compare(const BrickLevels<3>& levels, float within);

}  // namespace gridstep
