#pragma once

#include <vector>

#include "estimators/integral_invariant/bricks/ball_rows.hpp"
#include "estimators/integral_invariant/bricks/exact_sums.hpp"
#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// What a ball has in full rows of bricks, and in full sides of them: prefix sums over the rows for every
/// alignment of the lines. Sides are counted from the spel on, x > 0, so that an alignment along x needs no sums
/// of its own; what is too much is known for a source brick (Surplus).
///
/// The parts of a whole row are to be asked for all together: here they are cut where the spel sees them, not
/// between bricks. Rows of the middle that others may follow (reach = kMostBricks) are not to be asked for, nor
/// are those that follow: their points are not all their own.
///
/// Memory: 64 (2D: 8) sums for each row of the middle, twice as many for each other one.
template <int d, class Sum>
class FullRowSums {
 public:
  explicit FullRowSums(const BallRows<d>& ball);

  /// What sum() has too much: the points between a spel and the sides that are full, on the left those at the
  /// spel's x too where the ball is skew. Positions are taken from the source brick.
  class Surplus {
   public:
    Sum of(int bit) const {
      const int lead = bit % kLength;
      Sum sum = up_to_sides_;
      subtract(sum, extruded<0>(right_, Stretch(0, lead + 1)));
      subtract(sum, extruded<0>(left_, Stretch(lead + skew_, kLength - lead - skew_)));
      return sum;
    }

   private:
    friend FullRowSums;
    int skew_;
    Sum up_to_sides_;   // from the source brick on, its own points included
    Sum right_, left_;  // of those, on a plane x = 0
  };
  Surplus surplus(const SourceLists<d, Sum>& lists) const;

  /// What the ball around the spel `bit` has in all of F, and the surplus. Positions are taken from the spel.
  Sum sum(const SourceLists<d, Sum>& lists, int bit) const {
    const auto line = std::size_t(bit / kLength);
    Sum result;
    add_rows(result, lists.left.full, &sides_[line], Lines<d>::kCount);
    mirror_x(result);
    if (skew_) result.move(-LatticePoint<d>::Unit(0));
    add_rows(result, lists.right.full, &sides_[line], Lines<d>::kCount);
    add_rows(result, lists.rows.full, &rows_[line], Lines<d>::kCount);
    return result;
  }
  std::size_t memory() const {
    return (rows_.size() + sides_.size() + up_to_sides_.size() + planes_.size()) * sizeof(Sum);
  }

 private:
  static constexpr int kLength = Lines<d>::kLength;

  /// before: of all earlier rows, `stride` sums for each.
  static void add_rows(Sum& sum, const std::vector<FullRows>& rows, const Sum* before, std::size_t stride) {
    for (const FullRows& range : rows) {
      add(sum, before[range.end * stride]);
      subtract(sum, before[range.begin * stride]);
    }
  }

  int skew_;
  std::vector<Sum> rows_, sides_;  // for all lines of the source brick of one row after the other
  std::vector<Sum> up_to_sides_;   // of the bricks from the source brick up to the right side
  std::vector<Sum> planes_;        // of what they have at x = 0
};

}  // namespace gridstep::bricks
