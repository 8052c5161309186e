#include "estimators/integral_invariant/bricks/full_row_sums.hpp"

#include <algorithm>
#include <utility>

namespace gridstep::bricks {

template <int d, class Sum>
FullRowSums<d, Sum>::FullRowSums(const BallRows<d>& ball)
    : skew_(ball.skew()),
      rows_(Lines<d>::kCount * (ball.rows().size() + 1)),
      sides_(Lines<d>::kCount * (ball.sides().size() + 1)),
      up_to_sides_(ball.sides().size() + 1),
      planes_(ball.sides().size() + 1) {
  for (int line = 0; line < Lines<d>::kCount; ++line) {
    const auto* widths = ball.widths(line);
    // Adds a stretch of each line of a row, the one that begin_and_end(width) says, x counted from the spel.
    const auto add_lines = [&](Sum& sum, std::size_t row, auto begin_and_end) {
      for (int other = 0; other < Lines<d>::kCount; ++other) {
        const auto [begin, end] = begin_and_end(int(widths[row].of[std::size_t(other)]));
        LatticePoint<d> first = Brick<d>::origin(ball.rows()[row].brick) + Brick<d>::offset(other * kLength) -
                                Brick<d>::offset(line * kLength);
        first[0] = begin;
        LatticePoint<d> extent = LatticePoint<d>::Ones();
        extent[0] = end - begin;
        if (begin < end) add_box(sum, first, extent);
      }
    };
    Sum rows, sides;
    for (std::size_t i = 0; i < ball.rows().size(); ++i) {
      const auto& row = ball.rows()[i];
      if (i < ball.middle().size()) {
        add_lines(rows, i, [&](int width) {
          const int end = width - kLength + 1;
          return std::pair(skew_ - end + 1, end);
        });
      } else {
        Sum side;
        const int begin = row.base() - kLength + 1, most = (row.reach + 1 - row.near) * kLength;
        add_lines(side, i,
                  [&](int width) { return std::pair(row.whole ? 1 : begin, begin + std::min(width, most)); });
        add(sides, side);
        add(rows, side);
        mirror_x(side);
        if (skew_) side.move(-LatticePoint<d>::Unit(0));
        add(rows, side);
        if (row.whole && !skew_) add_lines(rows, i, [](int) { return std::pair(0, 1); });
        sides_[(i - ball.middle().size() + 1) * Lines<d>::kCount + std::size_t(line)] = sides;
      }
      rows_[(i + 1) * Lines<d>::kCount + std::size_t(line)] = rows;
    }
  }
  Sum bricks, plane;
  for (std::size_t i = 0; i < ball.sides().size(); ++i) {
    const auto& row = ball.sides()[i];
    if (row.whole) {
      BrickRows<d, Sum>::add_full(bricks, row.brick, 0, row.near);
      LatticePoint<d> extent = LatticePoint<d>::Ones();
      for (int k = 1; k < d; ++k) extent[k] = Brick<d>::extent(k);
      add_box(plane, Brick<d>::origin(row.brick), extent);
    }
    up_to_sides_[i + 1] = bricks;
    planes_[i + 1] = plane;
  }
}

template <int d, class Sum>
auto FullRowSums<d, Sum>::surplus(const SourceLists<d, Sum>& lists) const -> Surplus {
  Surplus result;
  result.skew_ = skew_;
  add_rows(result.up_to_sides_, lists.left.full, up_to_sides_.data(), 1);
  mirror_x(result.up_to_sides_);
  result.up_to_sides_.move(-(kLength - 1) * LatticePoint<d>::Unit(0));
  add_rows(result.up_to_sides_, lists.right.full, up_to_sides_.data(), 1);
  add_rows(result.right_, lists.right.full, planes_.data(), 1);
  add_rows(result.left_, lists.left.full, planes_.data(), 1);
  return result;
}

template class FullRowSums<2, Counts<2>>;
template class FullRowSums<3, Counts<3>>;
template class FullRowSums<2, Moments<2>>;
template class FullRowSums<3, Moments<3>>;

}  // namespace gridstep::bricks
