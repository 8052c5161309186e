#pragma once

#include <array>
#include <cstdint>

namespace gridstep {

/// Sums of integer weights over the digital set in the ball around a surfel's centre c. The coordinates of
/// x = 2 (p - c) are odd along the surfel's axis and even along the others.
struct RadialSum {
  std::int64_t trace = 0;
  std::int64_t edge = 0;
  std::array<std::int64_t, 3> edge_first{};  ///< sum of edge weight times x_i; 3D
  std::array<std::int64_t, 6>
      tensor_second{};  ///< sum of tensor weight times x_i x_j: xx, xy, xz, yy, yz, zz; 3D

  RadialSum& operator+=(const RadialSum& other) {
    trace += other.trace;
    edge += other.edge;
    for (std::size_t i = 0; i < 3; ++i) edge_first[i] += other.edge_first[i];
    for (std::size_t i = 0; i < 6; ++i) tensor_second[i] += other.tensor_second[i];
    return *this;
  }
  RadialSum& operator-=(const RadialSum& other) {
    trace -= other.trace;
    edge -= other.edge;
    for (std::size_t i = 0; i < 3; ++i) edge_first[i] -= other.edge_first[i];
    for (std::size_t i = 0; i < 6; ++i) tensor_second[i] -= other.tensor_second[i];
    return *this;
  }
  friend bool operator==(const RadialSum&, const RadialSum&) = default;
};

}  // namespace gridstep
