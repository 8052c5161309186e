#pragma once

#include <vector>

#include "estimators/integral_invariant/bricks/ball_rows.hpp"
#include "estimators/integral_invariant/bricks/exact_sums.hpp"
#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// What a ball has in full rows of bricks, for every alignment: prefix sums over the rows of the middle, and over what the
/// others hold beyond their whole bricks, to one side of the source brick. Positions are taken from the spel.
///
/// Memory: 64 (2D: 8) sums for each row of the middle, 576 (2D: 520) for each other one.
template <int d, class Sum>
class FullRowSums {
 public:
  explicit FullRowSums(const BallRows<d>& ball);

  Sum middle(const std::vector<FullRows>& rows, int bit) const {
    return total(rows, middle_.data() + bit / kLength, Lines<d>::kCount);
  }
  Sum right(const std::vector<FullRows>& rows, int bit) const { return side(rows, bit / kLength, bit % kLength); }
  /// The left side is the right one of the mirrored alignment.
  Sum left(const std::vector<FullRows>& rows, int bit) const {
    Sum sum = side(rows, bit / kLength, kLength - 1 - bit % kLength - skew_);
    mirror_x(sum);
    if (skew_) sum.move(-LatticePoint<d>::Unit(0));
    return sum;
  }
  std::size_t memory() const { return (middle_.size() + sides_.size()) * sizeof(Sum); }

 private:
  static constexpr int kLength = Lines<d>::kLength;
  static constexpr std::size_t kAlignments = Lines<d>::kCount * (kLength + 1);

  /// lead: the spel's position in its line, -1 <= lead < kLength.
  static std::size_t alignment(int line, int lead) { return std::size_t(line * (kLength + 1) + lead + 1); }
  Sum side(const std::vector<FullRows>& rows, int line, int lead) const {
    return total(rows, sides_.data() + alignment(line, lead), kAlignments);
  }
  static Sum total(const std::vector<FullRows>& rows, const Sum* before, std::size_t alignments) {
    Sum result;
    for (const FullRows& range : rows) {
      add(result, before[range.end * alignments]);
      subtract(result, before[range.begin * alignments]);
    }
    return result;
  }

  int skew_;
  std::vector<Sum> middle_, sides_;  // of all earlier rows, for all alignments of one row after the other
};

}  // namespace gridstep::bricks
