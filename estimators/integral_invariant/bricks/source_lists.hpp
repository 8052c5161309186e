#pragma once

#include <cstdint>
#include <vector>

#include "estimators/integral_invariant/bricks/ball_rows.hpp"
#include "estimators/integral_invariant/bricks/brick_rows.hpp"

namespace gridstep::bricks {

/// A mixed brick that a ball boundary may cross: an entry of M.
struct MixedBrick {
  const std::uint64_t* words;
  std::uint32_t row;    ///< of BallRows
  std::uint16_t from;   ///< points between the base of the ball's row and the brick's near end
  std::int16_t offset;  ///< bricks along x from the source brick
};

/// A run of full bricks that a ball boundary may cross, in a half-row that is not all full: an entry of F.
struct FullRun {
  std::uint32_t row;     ///< of BallRows
  std::uint16_t from;    ///< points between the base of the ball's row and the run's near end
  std::uint16_t length;  ///< points
  std::int16_t offset;   ///< of the brick nearest to the source brick
};

/// Successive rows of BallRows, `end` excluded, whose half on one side is full wherever a ball boundary may cross
/// it: entries of F that are summed up in HalfRowSums.
struct FullHalfRows {
  std::uint32_t begin, end;
};

/// What the balls around the spels of one source brick have in common.
template <int d, class Sum>
struct SourceLists {
  struct Side {
    std::vector<MixedBrick> mixed;
    std::vector<FullRun> full;
    std::vector<FullHalfRows> half_rows;
  };
  Sum inside;                      ///< C: the points in bricks inside every ball
  std::vector<MixedBrick> middle;  ///< bricks at offset 0, which a ball may cut at both ends; M, or full
  Side right, left;                ///< M and F

  /// Entries that each spel visits.
  std::size_t size() const {
    return middle.size() + right.mixed.size() + right.full.size() + left.mixed.size() + left.full.size();
  }

  /// Cost: the rows of the ball, and the runs of the set that a ball boundary may cross.
  void build(const BallRows<d>& ball, const BrickRows<d, Sum>& set, const LatticePoint<d>& source);
};

}  // namespace gridstep::bricks
