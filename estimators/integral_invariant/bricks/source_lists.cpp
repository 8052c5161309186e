#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

namespace {

void extend(std::vector<FullSides>& full, std::uint32_t row) {
  if (!full.empty() && full.back().end == row)
    ++full.back().end;
  else
    full.push_back({row, row + 1});
}

/// Lists what lies in bricks lo to hi, counted from the source brick x; `first` is the first run that ends behind lo.
template <int d, class Sum, class Run>
void list_part(std::vector<CutRow<d, Sum>>& cut, std::uint32_t row, int lo, int hi, const Run* first, int x) {
  const Run* last = first;
  while (last->begin <= x + hi) ++last;
  if (last != first) cut.push_back({row, lo, hi, first, last});
}

template <class Side, class Run>
void list_side(Side& side, std::uint32_t row, int lo, int hi, const Run* first, int x) {
  if (!first->mixed && first->begin <= x + lo && first->end > x + hi)
    extend(side.full, row);
  else
    list_part(side.cut, row, lo, hi, first, x);
}

}  // namespace

template <int d, class Sum>
std::size_t SourceLists<d, Sum>::size() const {
  std::size_t result = 0;
  for (const auto* cut : {&middle, &right.cut, &left.cut})
    for (const CutRow<d, Sum>& part : *cut) result += std::size_t(part.last - part.first);
  return result;
}

template <int d, class Sum>
void SourceLists<d, Sum>::build(const BallRows<d>& ball, const BrickRows<d, Sum>& set,
                                const LatticePoint<d>& source) {
  x = source[0];
  inside = {};
  middle.clear();
  for (Side* side : {&right, &left}) {
    side->cut.clear();
    side->full.clear();
  }
  for (std::uint32_t index = 0; index < ball.rows().size(); ++index) {
    const auto& ball_row = ball.rows()[index];
    const LatticePoint<d> brick = source + ball_row.brick;
    const auto row = set.row(brick);
    if (row.empty()) continue;
    const int near = ball_row.near, far = ball_row.reach;
    const auto* run = set.find(row, x - far);
    if (run->begin > x + far) continue;
    const auto behind = [&](int end) {
      while (run->end <= end) ++run;
      return run;
    };
    if (near == 0) {
      list_part(middle, index, -far, far, run, x);
      continue;
    }
    list_side(left, index, -far, -near, run, x);
    if (ball_row.whole) {
      const int begin = x - near + 1, end = x + near;
      subtract(inside, set.before(behind(begin), brick, begin));
      add(inside, set.before(behind(end), brick, end));
    }
    list_side(right, index, near, far, behind(x + near), x);
  }
}

template struct SourceLists<2, Counts<2>>;
template struct SourceLists<3, Counts<3>>;
template struct SourceLists<3, Moments>;

}  // namespace gridstep::bricks
