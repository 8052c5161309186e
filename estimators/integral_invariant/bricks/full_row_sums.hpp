#pragma once

#include <vector>

#include "estimators/integral_invariant/bricks/ball_rows.hpp"
#include "estimators/integral_invariant/bricks/exact_sums.hpp"
#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// What a ball has in full rows of bricks, for every alignment: prefix sums over the rows of the middle, and over what the
/// others hold beyond their whole bricks, to one side of the source brick. Positions are taken from the spel. Rows of the
/// middle that others may follow (reach = kMostBricks) are not to be asked for: their points are not all their own.
///
/// Memory: 64 (2D: 8) sums for each row of the middle, 576 (2D: 520) for each other one.
template <int d, class Sum>
class FullRowSums {
 public:
  explicit FullRowSums(const BallRows<d>& ball);

  /// What the ball around the spel `bit` has in all of F.
  Sum sum(const SourceLists<d, Sum>& lists, int bit) const {
    const int line = bit / kLength, lead = bit % kLength;
    Sum result;
    // The left side is the right one of the mirrored alignment.
    add_rows(result, lists.left.full, &sides_[alignment(line, kLength - 1 - lead - skew_)], kAlignments);
    mirror_x(result);
    if (skew_) result.move(-LatticePoint<d>::Unit(0));
    add_rows(result, lists.right.full, &sides_[alignment(line, lead)], kAlignments);
    add_rows(result, lists.middle.full, &middle_[std::size_t(line)], Lines<d>::kCount);
    return result;
  }
  std::size_t memory() const { return (middle_.size() + sides_.size()) * sizeof(Sum); }

 private:
  static constexpr int kLength = Lines<d>::kLength;
  static constexpr std::size_t kAlignments = Lines<d>::kCount * (kLength + 1);

  /// lead: the spel's position in its line, -1 <= lead < kLength.
  static std::size_t alignment(int line, int lead) { return std::size_t(line * (kLength + 1) + lead + 1); }
  static void add_rows(Sum& sum, const std::vector<FullRows>& rows, const Sum* before,
                       std::size_t alignments) {
    for (const FullRows& range : rows) {
      add(sum, before[range.end * alignments]);
      subtract(sum, before[range.begin * alignments]);
    }
  }

  int skew_;
  std::vector<Sum> middle_, sides_;  // of all earlier rows, for all alignments of one row after the other
};

}  // namespace gridstep::bricks
