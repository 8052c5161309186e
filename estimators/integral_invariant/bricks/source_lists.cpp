#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

namespace {

void extend(std::vector<FullRows>& full, std::uint32_t begin, std::uint32_t end) {
  if (!full.empty() && full.back().end == begin)
    full.back().end = end;
  else
    full.push_back({begin, end});
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
  for (const Parts* parts : {&rows, &right, &left})
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
      extend(rows.full, i, i + 1);
    else
      list_cut(rows.cut, i, -far, far, run, x);
  }
}

template <int d, class Sum>
void SourceLists<d, Sum>::build_sides(const BallRows<d>& ball, const BrickRows<d, Sum>& set,
                                      const LatticePoint<d>& source) {
  const auto first_side = std::uint32_t(ball.middle().size());
  for (std::uint32_t begin = 0, end; begin < ball.sides().size(); begin = end) {
    const auto& head = ball.sides()[begin];
    end = begin + std::uint32_t(head.parts);
    const LatticePoint<d> brick = source + head.brick;
    const auto row = set.row(brick);
    if (row.empty()) continue;
    const int near = head.near, far = ball.sides()[end - 1].reach;
    const auto* run = set.find(row, x - far);
    if (run->begin > x + far) continue;
    if (head.whole && is_full(-far, far, run, x)) {
      extend(rows.full, first_side + begin, first_side + end);
      continue;
    }
    const auto behind = [&](int last) {
      while (run->end <= last) ++run;
      return run;
    };
    if (head.whole && is_full(-far, -near, run, x))
      extend(left.full, begin, end);
    else
      for (std::uint32_t i = end; i-- > begin;) {
        const auto& part = ball.sides()[i];
        list_cut(left.cut, first_side + i, -part.reach, -part.near, behind(x - part.reach - 1), x);
      }
    if (head.whole) {
      subtract(inside, set.before(behind(x - near + 1), brick, x - near + 1));
      add(inside, set.before(behind(x + near), brick, x + near));
    }
    if (head.whole && is_full(near, far, behind(x + near), x))
      extend(right.full, begin, end);
    else
      for (std::uint32_t i = begin; i < end; ++i) {
        const auto& part = ball.sides()[i];
        list_cut(right.cut, first_side + i, part.near, part.reach, behind(x + part.near), x);
      }
  }
}

template <int d, class Sum>
void SourceLists<d, Sum>::build(const BallRows<d>& ball, const BrickRows<d, Sum>& set,
                                const LatticePoint<d>& source) {
  x = source[0];
  inside = {};
  for (Parts* parts : {&rows, &right, &left}) {
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
