#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "estimators/integral_invariant/radial/huge_pages.hpp"
#include "estimators/integral_invariant/radial/line_flux.hpp"
#include "estimators/integral_invariant/radial/radial_weights.hpp"
#include "shapes/base/lattice.hpp"

namespace gridstep {

/// The kernels around the centre of a surfel orthogonal to an axis, summed up along x: an entry is the sum over the line
/// that begins at its point and goes up x to the ball's end.
/// Flux: WholeFlux or CurvatureFlux.
template <class Flux>
class FluxTables {
 public:
  FluxTables(const RadialWeights& weights, DigitalLength radius, int half_axis);

  int half_axis() const { return half_axis_; }

  /// No offset of the ball has a coordinate beyond -reach to reach.
  int reach() const { return reach_; }
  /// Bricks from a spel's own brick, along an axis, beyond which there is nothing of its ball.
  int most() const { return most_; }
  /// Lines (y, z) of the ball, for z from -reach to reach: low <= y <= high, none where high < low.
  struct Lines {
    int low = 0, high = -1;
  };
  const Lines& lines(int z) const { return lines_[std::size_t(z + reach_)]; }

  /// Entries from a point to its neighbours along x, y and z. Those of a surface, near to each other on lines side by side
  /// rather than on one, are near to each other in memory.
  using Strides = std::array<std::int32_t, 3>;
  const Strides& strides() const { return strides_; }
  /// The entry of the spel itself, in the first of two tables. x may be from -8 most() - 7 to 8 most() + 7, and (y, z) is
  /// one of the ball's lines.
  const Flux* line_ends() const { return &along_x_[entry(0, 0, 0)]; }
  /// In the second table an entry is the sum over whole lines, from its y up: y may be what x was, and offsets of one along y and
  /// z are one entry and face_stride().
  const typename Flux::Sum* face_ends() const {
    return &along_y_[std::size_t(reach_ * face_stride() + margin())];
  }
  std::int32_t face_stride() const { return 2 * margin() + 1; }

 private:
  int margin() const { return 8 * most_ + 7; }
  std::size_t entry(int x, int y, int z) const {
    return std::size_t((x + margin()) * strides_[0] + (y + reach_) * strides_[1] +
                       (z + reach_) * strides_[2]);
  }

  int half_axis_, reach_, most_;
  Strides strides_;
  std::vector<Lines> lines_;
  std::vector<Flux, HugePages<Flux>> along_x_;
  std::vector<typename Flux::Sum> along_y_;
};

extern template class FluxTables<CurvatureFlux>;
extern template class FluxTables<WholeFlux>;

}  // namespace gridstep
