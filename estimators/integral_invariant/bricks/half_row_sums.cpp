#include "estimators/integral_invariant/bricks/half_row_sums.hpp"

#include <algorithm>

namespace gridstep::bricks {

template <int d, class Sum>
HalfRowSums<d, Sum>::HalfRowSums(const BallRows<d>& ball)
    : skew_(ball.skew()), sums_(kAlignments * (ball.rows().size() + 1)) {
  for (int line = 0; line < Lines<d>::kCount; ++line) {
    const auto* const widths = ball.widths(line);
    for (int lead = -1; lead < kLength; ++lead) {
      Sum sum;
      for (std::size_t row = 0; row < ball.rows().size(); ++row) {
        const auto& ball_row = ball.rows()[row];
        LatticePoint<d> first = Brick<d>::origin(ball_row.brick) - Brick<d>::offset(line * kLength);
        first[0] = ball_row.base() - lead;
        const int from = kLength - 1 - lead, most = (ball_row.reach + 1 - ball_row.near) * kLength;
        for (int other = 0; ball_row.near > 0 && other < Lines<d>::kCount; ++other) {
          const int length = std::min(int(widths[row].of[std::size_t(other)]) - from, most);
          if (length > 0)
            add_stretch(sum, LatticePoint<d>(first + Brick<d>::offset(other * kLength)), length);
        }
        sums_[(row + 1) * kAlignments + alignment(line, lead)] = sum;
      }
    }
  }
}

template class HalfRowSums<2, Counts<2>>;
template class HalfRowSums<3, Counts<3>>;
template class HalfRowSums<3, Moments>;

}  // namespace gridstep::bricks
