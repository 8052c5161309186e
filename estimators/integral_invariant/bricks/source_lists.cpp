#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

namespace {

void extend(std::vector<FullRows>& full, std::uint32_t row) {
  if (!full.empty() && full.back().end == row)
    ++full.back().end;
  else
    full.push_back({row, row + 1});
}

/// Lists what lies in bricks lo to hi, counted from the source brick x; `first` is the first run that ends behind lo.
template <int d, class Sum, class Run>
void list_cut(std::vector<CutRow<d, Sum>>& cut, std::uint32_t row, int lo, int hi, const Run* first, int x) {
  const Run* last = first;
  while (last->begin <= x + hi) ++last;
  if (last != first) cut.push_back({row, lo, hi, first, last});
}

template <class Run>
bool is_full(int lo, int hi, const Run* first, int x) {
  return !first->mixed && first->begin <= x + lo && first->end > x + hi;
}

}  // namespace

template <int d, class Sum>
std::size_t SourceLists<d, Sum>::size() const {
  std::size_t result = 0;
  for (const Parts* parts : {&middle, &right, &left})
    for (const CutRow<d, Sum>& part : parts->cut) result += std::size_t(part.last - part.first);
  return result;
}

template <int d, class Sum>
void SourceLists<d, Sum>::build_middle(const BallRows<d>& ball, const BrickRows<d, Sum>& set,
                                       const LatticePoint<d>& source) {
  for (std::uint32_t i = 0; i < ball.middle().size(); ++i) {
    const auto& ball_row = ball.middle()[i];
    const auto row = set.row(source + ball_row.brick);
    if (row.empty()) continue;
    const int far = ball_row.reach;
    const auto* run = set.find(row, x - far);
    // A row that others may follow does not hold all that the table has of it.
    if (far < BallRows<d>::kMostBricks && is_full(-far, far, run, x))
      extend(middle.full, i);
    else
      list_cut(middle.cut, i, -far, far, run, x);
  }
}

template <int d, class Sum>
void SourceLists<d, Sum>::build_sides(const BallRows<d>& ball, const BrickRows<d, Sum>& set,
                                      const LatticePoint<d>& source) {
  const auto first_side = std::uint32_t(ball.middle().size());
  const auto list = [&](Parts& side, std::uint32_t i, int lo, int hi, const auto* run) {
    if (is_full(lo, hi, run, x))
      extend(side.full, i);
    else
      list_cut(side.cut, first_side + i, lo, hi, run, x);
  };
  for (std::uint32_t i = 0; i < ball.sides().size(); ++i) {
    const auto& ball_row = ball.sides()[i];
    const LatticePoint<d> brick = source + ball_row.brick;
    const auto row = set.row(brick);
    if (row.empty()) continue;
    const int near = ball_row.near, far = ball_row.reach;
    const auto* run = set.find(row, x - far);
    if (run->begin > x + far) continue;
    if (is_full(-far, far, run, x)) {
      extend(left.full, i);
      extend(right.full, i);
      if (ball_row.whole) set.add_full(inside, brick, x - near + 1, x + near);
      continue;
    }
    const auto behind = [&](int end) {
      while (run->end <= end) ++run;
      return run;
    };
    list(left, i, -far, -near, run);
    if (ball_row.whole) {
      const int begin = x - near + 1, end = x + near;
      subtract(inside, set.before(behind(begin), brick, begin));
      add(inside, set.before(behind(end), brick, end));
    }
    list(right, i, near, far, behind(x + near));
  }
}

template <int d, class Sum>
void SourceLists<d, Sum>::build(const BallRows<d>& ball, const BrickRows<d, Sum>& set,
                                const LatticePoint<d>& source) {
  x = source[0];
  inside = {};
  for (Parts* parts : {&middle, &right, &left}) {
    parts->cut.clear();
    parts->full.clear();
  }
  build_middle(ball, set, source);
  build_sides(ball, set, source);
}

template struct SourceLists<2, Counts<2>>;
template struct SourceLists<3, Counts<3>>;
template struct SourceLists<3, Moments>;

}  // namespace gridstep::bricks
