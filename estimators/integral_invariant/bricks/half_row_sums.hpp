#pragma once

#include <vector>

#include "estimators/integral_invariant/bricks/ball_rows.hpp"
#include "estimators/integral_invariant/bricks/exact_sums.hpp"
#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// The part of a ball beyond its whole bricks, to one side of the source brick: prefix sums over the rows of the
/// ball, for every alignment. Positions are taken from the spel.
///
/// Memory: 576 (2D: 520) sums for each row of the ball.
template <int d, class Sum>
class HalfRowSums {
 public:
  explicit HalfRowSums(const BallRows<d>& ball);

  Sum right(const std::vector<FullHalfRows>& rows, int bit) const {
    return total(rows, bit / kLength, bit % kLength);
  }
  /// The left side is the right one of the mirrored alignment.
  Sum left(const std::vector<FullHalfRows>& rows, int bit) const {
    Sum sum = total(rows, bit / kLength, kLength - 1 - bit % kLength - skew_);
    mirror_x(sum);
    if (skew_) sum.move(-LatticePoint<d>::Unit(0));
    return sum;
  }
  std::size_t memory() const { return sums_.size() * sizeof(Sum); }

 private:
  static constexpr int kLength = Lines<d>::kLength;

  /// lead: the spel's position in its line, -1 <= lead < kLength.
  const Sum* prefix(int line, int lead) const {
    return sums_.data() + std::size_t(line * (kLength + 1) + lead + 1) * (rows_ + 1);
  }
  Sum total(const std::vector<FullHalfRows>& rows, int line, int lead) const {
    const Sum* const sums = prefix(line, lead);
    Sum result;
    for (const FullHalfRows& range : rows) {
      add(result, sums[range.end]);
      subtract(result, sums[range.begin]);
    }
    return result;
  }

  std::size_t rows_;
  int skew_;
  std::vector<Sum> sums_;
};

}  // namespace gridstep::bricks
