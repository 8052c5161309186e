#include "estimators/integral_invariant/bricks/brick_rows.hpp"

#include <limits>

#include "estimators/integral_invariant/bricks/brick_sums.hpp"

namespace gridstep::bricks {

namespace {

/// Pages of one row that are not empty; neighbours that are full are one piece.
struct Piece {
  int begin, end;      // pages along x
  std::int32_t state;  // see DigitalSet::page_state()
};

template <int d>
std::vector<Piece> pieces_of(const DigitalSet<d>& set, LatticePoint<d> page, int begin, int end) {
  std::vector<Piece> pieces;
  for (page[0] = begin; page[0] < end; ++page[0]) {
    const std::int32_t state = set.page_state(page);
    if (state == DigitalSet<d>::kEmpty) continue;
    const bool goes_on = state == DigitalSet<d>::kFull && !pieces.empty() && pieces.back().state == state &&
                         pieces.back().end == page[0];
    if (goes_on)
      ++pieces.back().end;
    else
      pieces.push_back({page[0], page[0] + 1, state});
  }
  return pieces;
}

template <int d>
LatticePoint<d> page_of(const LatticePoint<d>& brick) {
  return brick.unaryExpr([](int x) { return x >> DigitalSet<d>::kPageShift; });
}

}  // namespace

template <int d, class Sum>
BrickRows<d, Sum>::BrickRows(const DigitalSet<d>& set, const LatticeBox<d>& box)
    : box_(box.intersection(set.brick_box())) {
  if (box_.empty()) box_ = {LatticePoint<d>::Zero(), LatticePoint<d>::Zero()};
  extent_ = box_.extent();
  const LatticePoint<d> first_page = page_of<d>(box_.lo), last_page = page_of<d>(box_.hi);

  LatticePoint<d> known = first_page;  // the row of pages that `pieces` are of
  std::vector<Piece> pieces = pieces_of<d>(set, known, first_page[0], last_page[0] + 1);
  LatticeBox<d> row_starts = box_;
  row_starts.hi[0] = row_starts.lo[0];
  for_each_point(row_starts, [&](const LatticePoint<d>& start) {
    LatticePoint<d> page = page_of<d>(start);
    if (page != known) {
      known = page;
      pieces = pieces_of<d>(set, page, first_page[0], last_page[0] + 1);
    }
    row_begin_.push_back(runs_.size());
    Sum sum;
    const auto add_full_run = [&](int begin, int end) {
      const bool continues =
          runs_.size() > row_begin_.back() && !runs_.back().mixed && runs_.back().end == begin;
      if (continues)
        runs_.back().end = end;
      else
        runs_.push_back({begin, end, nullptr, sum});
      add_full(sum, start, begin, end);
    };
    LatticePoint<d> brick = start;
    for (const Piece& piece : pieces) {
      const int begin = piece.begin * DigitalSet<d>::kPageSide, end = piece.end * DigitalSet<d>::kPageSide;
      if (piece.state == DigitalSet<d>::kFull) {
        add_full_run(begin, end);
        continue;
      }
      brick[0] = begin;
      const std::int32_t* state = set.states_in_page(piece.state).data() + DigitalSet<d>::index_in_page(brick);
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
    constexpr int kInfinity = std::numeric_limits<int>::max();
    runs_.push_back({kInfinity, kInfinity, nullptr, sum});
  });
  row_begin_.push_back(runs_.size());
}

template class BrickRows<2, Counts<2>>;
template class BrickRows<3, Counts<3>>;
template class BrickRows<3, Moments>;

}  // namespace gridstep::bricks
