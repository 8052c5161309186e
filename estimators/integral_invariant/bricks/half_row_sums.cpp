#include "estimators/integral_invariant/bricks/half_row_sums.hpp"

namespace gridstep::bricks {

template <int d, class Sum>
HalfRowSums<d, Sum>::HalfRowSums(const BallRows<d>& ball)
    : rows_(ball.rows().size()),
      skew_(ball.skew()),
      sums_(std::size_t(Lines<d>::kCount * (kLength + 1)) * (rows_ + 1)) {
  for (int line = 0; line < Lines<d>::kCount; ++line) {
    const auto* const widths = ball.widths(line);
    for (int lead = -1; lead < kLength; ++lead) {
      Sum sum;
      auto* out = sums_.data() + (prefix(line, lead) - sums_.data());
      for (std::size_t row = 0; row < rows_; ++row) {
        const auto& [brick, whole, reach] = ball.rows()[row];
        LatticePoint<d> first = Brick<d>::origin(brick) - Brick<d>::offset(line * kLength);
        first[0] = std::max(whole + 1, 1) * kLength - lead;
        const int from = first[0] - ball.rows()[row].base() + kLength - 1;
        for (int other = 0; other < Lines<d>::kCount; ++other) {
          const int length = int(widths[row].of[std::size_t(other)]) - from;
          if (length > 0)
            add_stretch(sum, LatticePoint<d>(first + Brick<d>::offset(other * kLength)), length);
        }
        out[row + 1] = sum;
      }
    }
  }
}

template class HalfRowSums<2, Counts<2>>;
template class HalfRowSums<3, Counts<3>>;
template class HalfRowSums<3, Moments>;

}  // namespace gridstep::bricks
