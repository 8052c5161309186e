#pragma once

// The evaluation strategy `bricks`: exact sums of a digital set over digital balls of one radius.
//
// The set is kept as bricks of 512 points, each empty, full or mixed. The spels to evaluate are grouped by the
// brick that they lie in, the source brick S. Seen from S, a brick falls into one of three kinds, whatever spel
// of S the ball is centred at, and so three lists, made once for S, serve all its spels (some 70 of them where
// the surface is smooth):
//
//            . . . . . . . . . .          C  bricks inside every ball: their points are the same for all spels,
//        . . F F|F F F F F F . .              a difference of prefix sums for each row of bricks
//      . . F F F|C C C C F F F . .        M  mixed bricks that some ball boundary may cross: for each spel the
//     . . F F C|C C C C C C F F . .           ball's lines in the brick become a mask: AND, then count
//     . M M M M|M M C C C C C F F .       F  full bricks that some ball boundary may cross, as runs along x: for
//     . . . . .|. M M M S M C C F .           each spel a sum of clipped half-widths; where the whole half of a
//      . . . . .|. . . . M M M M .             row is full, a difference in a table (HalfRowSums)
//        . . . . . . . . . . M M          .  bricks that are empty, or outside every ball: never visited
//            . . . . . . . .
//
// (M inside every ball counts for C.) The ball is a table of half-widths, one for each line along x, for each of
// the alignments of S's lines (BallRows); an alignment along x is an offset. Empty and full bricks are never
// looked at one by one (BrickRows), so that the work for a spel is what M and F hold: the bricks where ball
// boundary meets shape boundary, O((R/h)^(d-2)), in units of 512 points. Listing is O((R/h)^(d-1) / 64) (2D:
// R/h / 8) for each source brick.
//
// Nothing is rounded: sums are 64-bit integers, whatever the order of the additions, hence equal to those of the
// full kernel for every number of threads.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "estimators/integral_invariant/bricks/spels_by_brick.hpp"
#include "estimators/integral_invariant/convolution.hpp"
#include "shapes/base/units.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep::bricks {

/// Sums over the balls of one radius. Sum is PlainSum<d, std::int64_t> or, in 3D, MomentSums<3, std::int64_t>,
/// with offsets taken from the spel.
template <int d, class Sum>
class BallSums {
 public:
  /// Tables of the ball of ball_kernel(radius, half_axis).
  /// @throws InputError where R/h < 1, is not finite, or above 900 in 3D, 16384 in 2D.
  BallSums(DigitalLength radius, int half_axis);
  BallSums(BallSums&&) noexcept;
  BallSums& operator=(BallSums&&) noexcept;
  ~BallSums();

  /// Number of points of the ball.
  std::int64_t ball_size() const;
  /// Bytes of the tables.
  std::size_t memory() const;

  /// One sum for each spel, in the order of their positions. Runs on all threads of the current arena. In
  /// `work`, cells_visited are the entries of M and F, summed up over the spels.
  std::vector<Sum> eval(const DigitalSet<d>& set, const SpelsByBrick<d>& spels,
                        EvaluationWork* work = nullptr) const;

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

extern template class BallSums<2, PlainSum<2, std::int64_t>>;
extern template class BallSums<3, PlainSum<3, std::int64_t>>;
extern template class BallSums<3, MomentSums<3, std::int64_t>>;

}  // namespace gridstep::bricks
