#include "estimators/integral_invariant/bricks/brick_rows.hpp"

#include <limits>

#include "estimators/integral_invariant/bricks/brick_sums.hpp"

namespace gridstep::bricks {

template <int d, class Sum>
BrickRows<d, Sum>::BrickRows(const DigitalSet<d>& set, const LatticeBox<d>& box)
    : box_(box.intersection(set.brick_box())) {
  if (box_.empty()) box_ = {LatticePoint<d>::Zero(), LatticePoint<d>::Zero()};
  extent_ = box_.extent();
  constexpr int kInfinity = std::numeric_limits<int>::max();
  runs_.push_back({kInfinity, kInfinity, nullptr, {}});  // of all rows that have no runs
  const int end_page = DigitalSet<d>::page_of(box_.hi)[0] + 1;

  LatticePoint<d> known = DigitalSet<d>::page_of(box_.lo);  // the first page of the row that `pages` are of
  auto pages = set.page_runs(known, end_page);
  LatticeBox<d> row_starts = box_;
  row_starts.hi[0] = row_starts.lo[0];
  for_each_point(row_starts, [&](const LatticePoint<d>& start) {
    const LatticePoint<d> page = DigitalSet<d>::page_of(start);
    if (page != known) {
      known = page;
      pages = set.page_runs(known, end_page);
    }
    const std::size_t first = runs_.size();
    Sum sum;
    const auto add_full_run = [&](int begin, int end) {
      const bool continues = runs_.size() > first && !runs_.back().mixed && runs_.back().end == begin;
      if (continues)
        runs_.back().end = end;
      else
        runs_.push_back({begin, end, nullptr, sum});
      add_full(sum, start, begin, end);
    };
    LatticePoint<d> brick = start;
    for (const auto& run : pages) {
      const int begin = run.begin * DigitalSet<d>::kPageSide, end = run.end * DigitalSet<d>::kPageSide;
      if (run.state == DigitalSet<d>::kFull) {
        add_full_run(begin, end);
        continue;
      }
      brick[0] = begin;
      const std::int32_t* state = set.states_in_page(run.state).data() + DigitalSet<d>::index_in_page(brick);
      for (; brick[0] < end; ++brick[0], ++state) {
        if (*state == DigitalSet<d>::kEmpty) continue;
        const Brick<d>& bits = set.brick_of(*state);
        // A stored brick may have become uniform point by point.
        const int count = *state == DigitalSet<d>::kFull ? Brick<d>::kBits : bits.count();
        if (count == Brick<d>::kBits) add_full_run(brick[0], brick[0] + 1);
        if (count == 0 || count == Brick<d>::kBits) continue;
        runs_.push_back({brick[0], brick[0] + 1, &bits, sum});
        add_brick(sum, bits, Brick<d>::origin(brick));
      }
    }
    const bool none = runs_.size() == first;
    row_begin_.push_back(none ? 0 : first);
    if (!none) runs_.push_back({kInfinity, kInfinity, nullptr, sum});
  });
}

template class BrickRows<2, Counts<2>>;
template class BrickRows<3, Counts<3>>;
template class BrickRows<2, Moments<2>>;
template class BrickRows<3, Moments<3>>;

}  // namespace gridstep::bricks
