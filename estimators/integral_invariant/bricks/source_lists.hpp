#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "estimators/integral_invariant/bricks/ball_rows.hpp"
#include "estimators/integral_invariant/bricks/brick_rows.hpp"

namespace gridstep::bricks {

/// What a ball boundary may cross of a row of bricks, and where there are points of the set.
template <int d, class Sum>
struct CutRow {
  std::uint32_t row;     ///< of BallRows
  std::int32_t lo, hi;   ///< bricks along x from the source brick
  /// Runs of bricks, from left to right, `last` excluded; the outer ones may go on beyond lo and hi.
  const typename BrickRows<d, Sum>::Run *first, *last;
};

/// Successive rows that are full, counted in BallRows::rows(), or sides that are, counted in sides(); `end`
/// excluded. A whole row has all its parts among them. They are summed up in FullRowSums.
struct FullRows {
  std::uint32_t begin, end;
};

/// What the balls around the spels of one source brick have in common.
template <int d, class Sum>
struct SourceLists {
  struct Parts {
    std::vector<CutRow<d, Sum>> cut;  ///< E
    std::vector<FullRows> full;       ///< F
  };
  int x = 0;     ///< of the source brick
  Sum inside;    ///< C: the points in bricks inside every ball
  Parts rows;    ///< cut: of BallRows::middle(), a ball may cut them at both ends; full: from end to end
  Parts right, left;

  /// Runs of bricks that each spel visits.
  std::size_t size() const;
  /// Calls f(begin, end, mixed) for each run: its bricks along x from the source brick, `end` excluded, and the run's
  /// mixed brick or null.
  template <class F>
  void for_each_run(const CutRow<d, Sum>& part, F&& f) const {
    for (const auto* run = part.first; run != part.last; ++run)
      f(std::max(run->begin - x, part.lo), std::min(run->end - x, part.hi + 1), run->mixed);
  }

  /// Keeps both by reference.
  SourceLists(const BallRows<d>& ball, const BrickRows<d, Sum>& set)
      : ball_(&ball), set_(&set), last_(set.size()) {}

  /// Cost: the rows of the ball, and the runs of the set that a ball boundary may cross; where successive source bricks
  /// are far from each other, also the runs between them.
  void build(const LatticePoint<d>& source);

 private:
  void build_middle(const LatticePoint<d>& source);
  void build_sides(const LatticePoint<d>& source);

  const BallRows<d>* ball_;
  const BrickRows<d, Sum>* set_;
  std::vector<std::uint32_t> last_;  // of each row of the set, see BrickRows::find()
};

extern template struct SourceLists<2, Counts<2>>;
extern template struct SourceLists<3, Counts<3>>;
extern template struct SourceLists<2, Moments<2>>;
extern template struct SourceLists<3, Moments<3>>;

}  // namespace gridstep::bricks
