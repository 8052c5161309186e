#include "estimators/integral_invariant/bricks/full_row_sums.hpp"

#include <algorithm>

namespace gridstep::bricks {

template <int d, class Sum>
FullRowSums<d, Sum>::FullRowSums(const BallRows<d>& ball)
    : skew_(ball.skew()),
      middle_(Lines<d>::kCount * (ball.middle().size() + 1)),
      sides_(kAlignments * (ball.sides().size() + 1)) {
  for (int line = 0; line < Lines<d>::kCount; ++line) {
    const auto first_of = [line](const typename BallRows<d>::Row& row, int x, int other) {
      LatticePoint<d> first = Brick<d>::origin(row.brick) + Brick<d>::offset(other * kLength) - Brick<d>::offset(line * kLength);
      first[0] = x;
      return first;
    };
    const auto* widths = ball.widths(line);
    Sum sum;
    for (std::size_t i = 0; i < ball.middle().size(); ++i, ++widths) {
      for (int other = 0; other < Lines<d>::kCount; ++other) {
        const int end = int(widths->of[std::size_t(other)]) - kLength + 1, begin = skew_ - end + 1;
        if (begin < end) add_stretch(sum, first_of(ball.middle()[i], begin, other), end - begin);
      }
      middle_[(i + 1) * Lines<d>::kCount + std::size_t(line)] = sum;
    }
    for (int lead = -1; lead < kLength; ++lead) {
      sum = {};
      for (std::size_t i = 0; i < ball.sides().size(); ++i) {
        const auto& row = ball.sides()[i];
        const int from = kLength - 1 - lead, most = (row.reach + 1 - row.near) * kLength;
        for (int other = 0; other < Lines<d>::kCount; ++other) {
          const int length = std::min(int(widths[i].of[std::size_t(other)]) - from, most);
          if (length > 0) add_stretch(sum, first_of(row, row.base() - lead, other), length);
        }
        sides_[(i + 1) * kAlignments + alignment(line, lead)] = sum;
      }
    }
  }
}

template class FullRowSums<2, Counts<2>>;
template class FullRowSums<3, Counts<3>>;
template class FullRowSums<3, Moments>;

}  // namespace gridstep::bricks
