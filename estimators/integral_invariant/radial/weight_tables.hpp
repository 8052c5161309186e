#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "estimators/integral_invariant/radial/radial_sum.hpp"
#include "estimators/integral_invariant/radial/radial_weights.hpp"
#include "shapes/digital/brick.hpp"

namespace gridstep {

/// The kernels around the centre of a surfel orthogonal to an axis, as weights of offsets from its lower spel.
class WeightTables {
 public:
  WeightTables(const RadialWeights& weights, DigitalLength radius, int half_axis);

  int half_axis() const { return half_axis_; }
  /// No offset of the ball has a coordinate beyond -reach to reach.
  int reach() const { return reach_; }
  /// Bricks from the source brick, along an axis, beyond which there is nothing of the ball around any of its spels.
  int most() const { return most_; }

  /// Offsets from the spel at `bit` of the source brick to the origin of the brick that is `brick` bricks away.
  LatticePoint<3> offset(const LatticePoint<3>& brick, int bit) const {
    return Brick<3>::origin(brick) - Brick<3>::offset(bit);
  }
  /// Whether a brick at that offset, at most most() bricks away, has a point in the ball.
  bool meets(const LatticePoint<3>& offset) const {
    std::int64_t squared = 0;
    for (int k = 0; k < 3; ++k) squared += nearest_[std::size_t(k)][std::size_t(offset[k] + margin())];
    return squared <= limit_;
  }
  /// The weights of the point at that offset: those of trace, edge and tensor kernel are side() apart, points along x
  /// follow each other, lines along y are 3 side() and planes 3 side()^2 apart.
  const std::int32_t* begin(const LatticePoint<3>& offset) const {
    return &weights_[std::size_t(((offset[2] + margin()) * side_ + offset[1] + margin()) * 3 * side_ +
                                 offset[0] + margin())];
  }
  std::ptrdiff_t side() const { return side_; }

 private:
  /// No offset of a point in those bricks has a coordinate beyond -margin to margin.
  int margin() const { return 8 * most_ + 7; }

  int half_axis_, reach_, most_;
  std::int64_t limit_;
  std::ptrdiff_t side_;
  std::vector<std::int32_t> weights_;
  std::array<std::vector<std::int64_t>, 3>
      nearest_;  // least squared coordinate of eight in a row, in half cells
};

}  // namespace gridstep
