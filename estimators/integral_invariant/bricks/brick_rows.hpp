#pragma once

#include <cstdint>
#include <vector>

#include "estimators/integral_invariant/bricks/exact_sums.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep::bricks {

/// The part of a digital set in a box of bricks, row by row of bricks along x: mixed bricks and runs of full
/// ones, with prefix sums of their points. Empty bricks take no memory, so that a row across a shape has a
/// handful of runs. Keeps pointers into the set.
///
/// Sum is Modular<...>; positions are taken from the lattice's origin.
template <int d, class Sum>
class BrickRows {
 public:
  struct Run {
    int begin, end;         ///< bricks along x, `end` excluded
    const Brick<d>* mixed;  ///< one mixed brick, or null: full bricks
    Sum before;             ///< of the row's points in earlier runs
  };
  /// Cost: the stored bricks of the box, and its pages.
  BrickRows(const DigitalSet<d>& set, const LatticeBox<d>& box);

  /// Number of rows.
  std::size_t size() const { return row_begin_.size(); }
  /// The row of a brick, or size() outside the box.
  std::size_t row(const LatticePoint<d>& brick) const {
    std::size_t index = 0;
    for (int k = d - 1; k > 0; --k) {
      const int offset = brick[k] - box_.lo[k];
      if (offset < 0 || brick[k] > box_.hi[k]) return size();
      index = index * std::size_t(extent_[k]) + std::size_t(offset);
    }
    return index;
  }

  /// The runs of a row go from left to right; behind them lies a sentinel at infinity, with all points before it.
  /// This is the first run, or the sentinel, that ends behind brick x. `last` is where the row's last one was
  /// found, or 0: the search goes from there, since successive ones are close to each other.
  const Run* find(std::size_t row, int x, std::uint32_t& last) const {
    const Run *const first = runs_.data() + row_begin_[row], *run = first + last;
    while (run->end <= x) ++run;
    while (run != first && run[-1].end > x) --run;
    last = std::uint32_t(run - first);
    return run;
  }

  /// The points of the row left of brick x; run = find(row, x, last).
  static Sum before(const Run* run, const LatticePoint<d>& brick, int x) {
    Sum sum = run->before;
    if (run->begin < x) add_full(sum, brick, run->begin, x);
    return sum;
  }

  /// Adds full bricks of the row of `brick`, from brick `begin` on, without brick `end`.
  static void add_full(Sum& sum, LatticePoint<d> brick, int begin, int end) {
    brick[0] = begin;
    LatticePoint<d> extent;
    for (int k = 0; k < d; ++k) extent[k] = Brick<d>::extent(k);
    extent[0] *= end - begin;
    add_box(sum, Brick<d>::origin(brick), extent);
  }

  std::size_t memory() const { return runs_.capacity() * sizeof(Run) + row_begin_.capacity() * 8; }

 private:
  LatticeBox<d> box_;
  LatticePoint<d> extent_;
  std::vector<std::size_t> row_begin_;
  std::vector<Run> runs_;
};

}  // namespace gridstep::bricks
