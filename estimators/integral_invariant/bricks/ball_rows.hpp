#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/brick.hpp"

namespace gridstep::bricks {

/// The lines of a brick along x: 64 lines of 8 points in 3D, 8 lines of 64 points in 2D.
template <int d>
struct Lines {
  static constexpr int kLength = Brick<d>::extent(0);
  static constexpr int kCount = Brick<d>::kBits / kLength;
  using Width = std::conditional_t<d == 2, std::int64_t, std::uint8_t>;
  /// A number for each line of a brick; 64 bytes, a cache line.
  struct alignas(64) Widths {
    std::array<Width, kCount> of;
  };
};

/// A digital ball, cut into rows of bricks as it lies over the brick that holds its centre (the source brick):
///
///        -reach     -near       0       near       reach     brick offset along x
///           |- - - - -|===============|- - - - - - -|
///            some ball   inside every    some ball
///            boundary    ball            boundary
///
/// for whatever cell of the source brick the centre is in: its position in the brick is the `alignment` of the
/// ball. Where balls are narrow, a row is cut at both ends from the source brick on. The boundary itself is a
/// half-width for each line of each row of bricks, for each alignment of the lines; the alignment along x only
/// shifts it.
template <int d>
class BallRows {
 public:
  struct Row {
    LatticePoint<d> brick;  ///< offset from the source brick; 0 along x
    /// A ball boundary may cross bricks |x| = near to reach: one at each end, where near = 0 both in one brick.
    int near, reach;
    bool whole;     ///< whether bricks |x| < near are inside every ball; else another row holds them
    int parts = 1;  ///< of a whole row: so many successive ones, this one the first, hold its ends

    int base() const { return near * Lines<d>::kLength; }
  };
  /// The most bricks that a row has on a side: where it would have more, a row of the outer ones follows. In 3D, bytes
  /// can count the points of so many, and even those of a row cut at both ends, 8 (2 10 + 1) of them.
  static constexpr int kMostBricks = 10;

  /// The ball of ball_kernel(radius, half_axis).
  /// @throws InputError where R/h < 1 or not finite, or above 700 in 3D, 16384 in 2D.
  BallRows(DigitalLength radius, int half_axis);

  /// The rows with near = 0, the middle, and then the others.
  const std::vector<Row>& rows() const { return rows_; }
  std::span<const Row> middle() const { return std::span(rows_).first(middle_size_); }
  std::span<const Row> sides() const { return std::span(rows_).subspan(middle_size_); }
  /// Half-widths for a spel's line in its brick, one entry a row: of the line {(x, y, z)} with last point x = W,
  /// W + kLength - base, but at least 0, and at most what reaches all points of the row. W = skew() - 1 where the
  /// ball misses the line.
  const typename Lines<d>::Widths* widths(int line) const {
    return widths_.data() + std::size_t(line) * rows_.size();
  }
  /// For a spel's line, a flag for each row: whether the ball reaches its bricks of any x.
  const std::uint8_t* met(int line) const { return met_.data() + std::size_t(line) * rows_.size(); }
  /// 1 where the ball's centre is half a cell up x, so that it ends at x = 1 - W on the left; else 0.
  int skew() const { return skew_; }
  /// Number of points.
  std::int64_t size() const { return size_; }
  /// The ball's points have coordinates of at most this size.
  int radius() const { return radius_; }
  std::size_t memory() const {
    return widths_.size() * sizeof(widths_[0]) + met_.size() + rows_.size() * sizeof(Row);
  }

 private:
  std::vector<Row> rows_;
  std::size_t middle_size_ = 0;
  std::vector<typename Lines<d>::Widths> widths_;
  std::vector<std::uint8_t> met_;
  std::int64_t size_ = 0;
  int skew_, radius_ = 0;
};

/// The ball around one spel of its source brick.
template <int d>
struct AlignedBall {
  const BallRows<d>* ball;
  int bit;  ///< of the spel in the source brick

  const typename Lines<d>::Widths* widths() const { return ball->widths(bit / Lines<d>::kLength); }
  /// A line of a brick whose near end is `from` points beyond the base of its row, on the right, has
  /// width - from - to_right() points in the ball, where that is positive; likewise on the left.
  int to_right() const { return Lines<d>::kLength - 1 - bit % Lines<d>::kLength; }
  int to_left() const { return bit % Lines<d>::kLength + ball->skew(); }
};

extern template class BallRows<2>;
extern template class BallRows<3>;

}  // namespace gridstep::bricks
