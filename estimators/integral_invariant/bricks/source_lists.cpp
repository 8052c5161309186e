#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

namespace {

// What is done for each row of the ball is inlined by force: calls would take a fifth of the time.

[[gnu::always_inline]] inline void extend(std::vector<FullRows>& full, std::uint32_t begin,
                                          std::uint32_t end) {
  if (!full.empty() && full.back().end == begin)
    full.back().end = end;
  else
    full.push_back({begin, end});
}

/// Lists what lies in bricks lo to hi, counted from the source brick x; `first` is the first run that ends behind lo.
template <int d, class Sum, class Run>
[[gnu::always_inline]] inline void list_cut(std::vector<CutRow<d, Sum>>& cut, std::uint32_t row, int lo,
                                            int hi, const Run* first, int x) {
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
void SourceLists<d, Sum>::build_middle(const LatticePoint<d>& source) {
  const auto middle = ball_->middle();
  for (std::uint32_t i = 0; i < middle.size(); ++i) {
    const auto& ball_row = middle[i];
    const std::size_t row = set_->row(source + ball_row.brick);
    if (row == set_->size()) continue;
    const int far = ball_row.reach;
    const auto* run = set_->find(row, x - far, last_[row]);
    // A row that others may follow does not hold all that the table has of it.
    if (far < BallRows<d>::kMostBricks && is_full(-far, far, run, x))
      extend(rows.full, i, i + 1);
    else
      list_cut(rows.cut, i, -far, far, run, x);
  }
}

template <int d, class Sum>
void SourceLists<d, Sum>::build_sides(const LatticePoint<d>& source) {
  const auto sides = ball_->sides();
  const auto first_side = std::uint32_t(ball_->middle().size());
  for (std::uint32_t begin = 0, end; begin < sides.size(); begin = end) {
    const auto& head = sides[begin];
    end = begin + std::uint32_t(head.parts);
    const LatticePoint<d> brick = source + head.brick;
    const std::size_t row = set_->row(brick);
    if (row == set_->size()) continue;
    const int near = head.near, far = sides[end - 1].reach;
    const auto* run = set_->find(row, x - far, last_[row]);
    if (run->begin > x + far) continue;
    if (head.whole && is_full(-far, far, run, x)) {
      extend(rows.full, first_side + begin, first_side + end);
      continue;
    }
    // The first run that ends behind a brick; to be asked for bricks from left to right.
    const auto behind = [&](int brick_x) {
      while (run->end <= brick_x) ++run;
      return run;
    };
    if (head.whole && is_full(-far, -near, run, x))
      extend(left.full, begin, end);
    else
      for (std::uint32_t i = end; i-- > begin;) {
        const auto& part = sides[i];
        list_cut(left.cut, first_side + i, -part.reach, -part.near, behind(x - part.reach), x);
      }
    if (head.whole) {
      subtract(inside, set_->before(behind(x - near + 1), brick, x - near + 1));
      add(inside, set_->before(behind(x + near), brick, x + near));
    }
    if (head.whole && is_full(near, far, behind(x + near), x))
      extend(right.full, begin, end);
    else
      for (std::uint32_t i = begin; i < end; ++i) {
        const auto& part = sides[i];
        list_cut(right.cut, first_side + i, part.near, part.reach, behind(x + part.near), x);
      }
  }
}

template <int d, class Sum>
void SourceLists<d, Sum>::build(const LatticePoint<d>& source) {
  x = source[0];
  inside = {};
  for (Parts* parts : {&rows, &right, &left}) {
    parts->cut.clear();
    parts->full.clear();
  }
  build_middle(source);
  build_sides(source);
}

template struct SourceLists<2, Counts<2>>;
template struct SourceLists<3, Counts<3>>;
template struct SourceLists<2, Moments<2>>;
template struct SourceLists<3, Moments<3>>;

}  // namespace gridstep::bricks
