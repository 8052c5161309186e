#pragma once

// The evaluation strategy `bricks`: exact sums of a digital set over digital balls of one radius.
//
// The set is kept as bricks of 512 points, each empty, full or mixed. The spels to evaluate are grouped by the
// brick that they lie in, the source brick S. Seen from S, the rows of bricks along x fall into parts, whatever
// spel of S the ball is centred at, and so three lists, made once for S, serve all its spels (some 70 of them where
// the surface is smooth):
//
//            E E E E E E . . . .          C  bricks inside every ball: their points are the same for all spels,
//        E E E E|C C E E E . . .              a difference of prefix sums for each row of bricks
//      F F F F C|C C C C E E . .          E  parts of rows that a ball boundary may cross: the set's points on
//     F F F F C C|C C C C E E . .             each line of 8 points across are one run, begin <= x < end (where the
//     F F F C C C C|C S C C . . .             set is not smooth, several), and for each spel they are clipped by
//      F F F F C C C|C C C . . .              the ends of the ball: two at the top and bottom, where balls are
//        E E E E E E E|E . . . .              narrow, one on either side elsewhere
//            E E E E E E|. . . .          F  rows or sides that are full: a difference in a table (FullRowSums)
//                                         .  parts that are empty: never visited
//
// The ends of the ball are a table of half-widths, one for each line along x, for each of the alignments of S's lines
// (BallRows); an alignment along x is an offset. Empty and full bricks are never looked at one by one (BrickRows). In
// 3D, 64 bytes hold one number for each of the 64 lines of a row of bricks, so that a count of a run of E costs seven
// instructions of AVX-512. The work for a spel is what E holds: the rows where ball boundary meets shape boundary,
// O((R/h)^(d-2)). Listing is O((R/h)^(d-1) / 64) (2D: R/h / 8) for each source brick.
//
// Nothing is rounded: sums are integers, whatever the order of the additions, hence equal to those of the full kernel
// for every number of threads.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "estimators/integral_invariant/bricks/spels_by_brick.hpp"
#include "estimators/integral_invariant/convolution.hpp"
#include "shapes/base/uninitialized.hpp"
#include "shapes/base/units.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep::bricks {

/// Sums over the balls of one radius. Sum is PlainSum<d, std::int64_t> or MomentSums<d, std::int64_t>, with offsets taken
/// from the spel.
template <int d, class Sum>
class BallSums {
 public:
  /// Tables of the ball of ball_kernel(radius, half_axis).
  /// @throws InputError where R/h < 1, is not finite, or above 700 in 3D, 16384 in 2D.
  BallSums(DigitalLength radius, int half_axis);
  BallSums(BallSums&&) noexcept;
  BallSums& operator=(BallSums&&) noexcept;
  ~BallSums();

  /// Number of points of the ball.
  std::int64_t ball_size() const;
  /// Bytes of the tables.
  std::size_t memory() const;

  /// One sum for each spel, in the order of their positions. Runs on all threads of the current arena. In
  /// `work`, cells_visited are the runs of bricks in the parts of E, summed up over the spels.
  UninitializedVector<Sum> eval(const DigitalSet<d>& set, const SpelsByBrick<d>& spels,
                                EvaluationWork* work = nullptr) const;

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

extern template class BallSums<2, PlainSum<2, std::int64_t>>;
extern template class BallSums<2, MomentSums<2, std::int64_t>>;
extern template class BallSums<3, PlainSum<3, std::int64_t>>;
extern template class BallSums<3, MomentSums<3, std::int64_t>>;

}  // namespace gridstep::bricks
