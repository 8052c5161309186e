#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// The rows of the digital disk {z : |z| <= R/h}: the points of ball_kernel<2>(), as half-widths.
class DiskRows {
 public:
  /// @throws InputError where R/h < 1 or is not finite, or above 2^14.
  explicit DiskRows(DigitalLength radius);

  int reach() const { return int(half_width_.size()) - 1; }
  /// Row y, -reach() <= y <= reach(), holds x = -half_width(y) to half_width(y).
  int half_width(int y) const { return half_width_[std::size_t(y < 0 ? -y : y)]; }

 private:
  std::vector<int> half_width_;
};

/// A digital set as runs along x, row by row: numbers of points in parts of rows take one search.
class RowRuns {
 public:
  /// Cost O(N log N) for a boundary of N linels.
  explicit RowRuns(const DigitalSet<2>& set);

  /// Number of points (x, y) of the set with first <= x <= last. Cost O(log(runs of the row)).
  std::int64_t count(int y, int first, int last) const;

  /// Calls visit(a, b) for every run a..b of points (x, y) of the set with first <= x <= last, cut off there, in
  /// increasing order. Cost O(log(runs of the row)) and the runs.
  template <class Visit>
  void for_each_run(int y, int first, int last, Visit visit) const {
    const auto [begin, end] = runs_of(y);
    auto run = std::lower_bound(begin, end, first, [](const Run& r, int value) { return r.last < value; });
    for (; run != end && run->first <= last; ++run)
      visit(std::max(run->first, first), std::min(run->last, last));
  }

  /// Number of points in the disk around a digital point: the sum that `ii` takes with that radius, for radii
  /// that change from point to point. Cost O(R/h log(runs of a row)).
  std::int64_t count(const LatticePoint<2>& centre, const DiskRows& disk) const;

 private:
  struct Run {
    int first, last;
    std::int64_t before;  // points of the row in earlier runs
  };
  using Runs = std::vector<Run>;
  /// Begin and end of a row's runs.
  std::pair<Runs::const_iterator, Runs::const_iterator> runs_of(int y) const;
  std::int64_t count_up_to(int y, int x) const;

  int lowest_row_ = 0;
  std::vector<std::size_t> row_begin_;  // runs of row lowest_row_ + i: row_begin_[i] to row_begin_[i + 1]
  Runs runs_;
};

}  // namespace gridstep
