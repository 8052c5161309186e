#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "estimators/integral_invariant/radial/radial_sum.hpp"
#include "estimators/integral_invariant/radial/radial_weights.hpp"
#include "shapes/base/lattice.hpp"

namespace gridstep {

/// Sums of weights: the components of a RadialSum in their order, or the first ones of them.
template <std::size_t size>
struct alignas(size % 4 == 0 ? 32 : 16) FluxSum {
  std::array<std::int64_t, size> of{};

  FluxSum& operator+=(const FluxSum& other) {
    for (std::size_t i = 0; i < size; ++i) of[i] += other.of[i];
    return *this;
  }
  FluxSum& operator-=(const FluxSum& other) {
    for (std::size_t i = 0; i < size; ++i) of[i] -= other.of[i];
    return *this;
  }
};
using CurvatureFlux = FluxSum<2>;  ///< trace and edge
using WholeFlux = FluxSum<12>;     ///< all eleven, and one that makes it even

/// The kernels around the centre of a surfel orthogonal to an axis, summed up along x: an entry is the sum over the line
/// that begins at its point and goes up x to the ball's end.
template <class Flux>
class FluxTables {
 public:
  FluxTables(const RadialWeights& weights, DigitalLength radius, int half_axis);

  /// No offset of the ball has a coordinate beyond -reach to reach.
  int reach() const { return reach_; }
  /// Bricks from a spel's own brick, along an axis, beyond which there is nothing of its ball.
  int most() const { return most_; }
  /// Lines (y, z) of the ball, for z from -reach to reach: low <= y <= high, none where high < low.
  struct Lines {
    int low = 0, high = -1;
  };
  const Lines& lines(int z) const { return lines_[std::size_t(z + reach_)]; }

  /// The entry of the spel itself, in the first of two tables; an offset of one along y, along z is so many entries. x may be
  /// from -8 most() - 7 to 8 most() + 7, and (y, z) is one of the ball's lines.
  const Flux* line_ends() const {
    return &along_x_[std::size_t(reach_ * stride_z_ + reach_ * stride_ + margin())];
  }
  std::int32_t stride() const { return stride_; }
  std::int32_t stride_z() const { return stride_z_; }
  /// In the second table an entry is the sum over whole lines, from its y up: y may be what x was, and an offset of one along z
  /// is stride() entries.
  const Flux* face_ends() const { return &along_y_[std::size_t(reach_ * stride_ + margin())]; }

 private:
  int margin() const { return 8 * most_ + 7; }

  int reach_, most_;
  std::int32_t stride_, stride_z_;
  std::vector<Lines> lines_;
  std::vector<Flux> along_x_, along_y_;
};

extern template class FluxTables<CurvatureFlux>;
extern template class FluxTables<WholeFlux>;

}  // namespace gridstep
