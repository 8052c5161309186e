#pragma once

#include <vector>

#include "estimators/integral_invariant/bricks/ball_rows.hpp"
#include "estimators/integral_invariant/bricks/exact_sums.hpp"
#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// The part of a ball beyond its whole bricks, to one side of the source brick: prefix sums over the rows of the
/// ball, for every alignment; without the rows that are cut at both ends. Positions are taken from the spel.
///
/// Memory: 576 (2D: 520) sums for each row of the ball.
template <int d, class Sum>
class HalfRowSums {
 public:
  explicit HalfRowSums(const BallRows<d>& ball);

  Sum right(const std::vector<FullSides>& rows, int bit) const {
    return total(rows, bit / kLength, bit % kLength);
  }
  /// The left side is the right one of the mirrored alignment.
  Sum left(const std::vector<FullSides>& rows, int bit) const {
    Sum sum = total(rows, bit / kLength, kLength - 1 - bit % kLength - skew_);
    mirror_x(sum);
    if (skew_) sum.move(-LatticePoint<d>::Unit(0));
    return sum;
  }
  std::size_t memory() const { return sums_.size() * sizeof(Sum); }

 private:
  static constexpr int kLength = Lines<d>::kLength;

  /// lead: the spel's position in its line, -1 <= lead < kLength.
  static std::size_t alignment(int line, int lead) { return std::size_t(line * (kLength + 1) + lead + 1); }
  Sum total(const std::vector<FullSides>& rows, int line, int lead) const {
    const Sum* const sums = sums_.data() + alignment(line, lead);
    Sum result;
    for (const FullSides& range : rows) {
      add(result, sums[range.end * kAlignments]);
      subtract(result, sums[range.begin * kAlignments]);
    }
    return result;
  }

  static constexpr std::size_t kAlignments = Lines<d>::kCount * (kLength + 1);

  int skew_;
  std::vector<Sum> sums_;  // of all earlier rows, for all alignments of one row after the other
};

}  // namespace gridstep::bricks
