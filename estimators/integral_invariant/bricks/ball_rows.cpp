#include "estimators/integral_invariant/bricks/ball_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimators/integral_invariant/kernel.hpp"
#include "estimators/integral_invariant/window.hpp"

namespace gridstep::bricks {

namespace {

/// The largest integer whose square is at most q.
std::int64_t integer_root(std::int64_t q) {
  auto s = std::int64_t(std::sqrt(double(q)));
  while (s * s > q) --s;
  while ((s + 1) * (s + 1) <= q) ++s;
  return s;
}

/// The bricks that hold the points at `offset` bricks from brick 0, seen from any cell of brick 0: a box of
/// relative positions.
template <int d>
LatticeBox<d> relative_positions(const LatticePoint<d>& offset) {
  LatticeBox<d> box{Brick<d>::origin(offset), Brick<d>::origin(offset)};
  for (int k = 1; k < d; ++k) {
    box.lo[k] -= Brick<d>::extent(k) - 1;
    box.hi[k] += Brick<d>::extent(k) - 1;
  }
  return box;
}

/// Of a row whose first one on a side is `first`: in 3D, sums of 2 x along two of its lines shall fit 16 bits.
template <int d>
int last_brick(int first) {
  const auto square = [](int bricks) { return bricks * bricks * Lines<d>::kLength * Lines<d>::kLength; };
  int last = std::max(first, 1) + BallRows<d>::kMostBricks - 1;
  if constexpr (d == 3)
    while (square(last + 1) - square(first) > std::numeric_limits<std::int16_t>::max() / 2) --last;
  return last;
}

}  // namespace

template <int d>
BallRows<d>::BallRows(DigitalLength radius, int half_axis) : skew_(half_axis == 0) {
  constexpr int kLargest = d == 2 ? 1 << 14 : 700;  // in 3D, the tables take 1 GB
  const std::int64_t limit = squared_diameter(radius);
  if (radius.value > kLargest)
    throw InputError(
        fmt::format("kernel radius R/h = {:.6g}: bricks take at most {}", radius.value, kLargest));
  radius_ = int(std::ceil(radius.value)) + 1;

  // The half-width of every line that a row of bricks may hold.
  LatticePoint<d> farthest = LatticePoint<d>::Zero(), farthest_brick = LatticePoint<d>::Zero();
  for (int k = 1; k < d; ++k) {
    farthest_brick[k] = (radius_ >> Brick<d>::kShift[std::size_t(k)]) + 1;
    farthest[k] = (farthest_brick[k] + 1) * Brick<d>::extent(k);
  }
  const LatticeBox<d> lines{-farthest, farthest};
  const WindowLayout<d> layout{lines.extent()};
  std::vector<int> half_widths(std::size_t(layout.volume()));
  for_each_point(lines, [&](const LatticePoint<d>& z) {
    std::int64_t rest = limit;
    for (int k = 1; k < d; ++k) {
      const std::int64_t doubled = 2 * std::int64_t{z[k]} - (k == half_axis);
      rest -= doubled * doubled;
    }
    const int W = rest < 0 ? skew_ - 1 : int((integer_root(rest) + skew_) / 2);
    half_widths[std::size_t(layout.distance(z - lines.lo))] = W;
    if (rest >= 0) size_ += 2 * W + 1 - skew_;
  });
  const auto half_width = [&](const LatticePoint<d>& z) {
    return half_widths[std::size_t(layout.distance(z - lines.lo))];
  };

  constexpr int kLength = Lines<d>::kLength;
  for_each_point(LatticeBox<d>{-farthest_brick, farthest_brick}, [&](const LatticePoint<d>& brick) {
    int least = std::numeric_limits<int>::max(), most = -1;
    for_each_point(relative_positions<d>(brick), [&](const LatticePoint<d>& z) {
      least = std::min(least, half_width(z));
      most = std::max(most, half_width(z));
    });
    if (2 * most + 1 - skew_ <= 0) return;
    const int near = (least + 1 - skew_) / kLength, reach = (most + kLength - 1) / kLength;
    const std::size_t head = rows_.size();
    for (int first = near; first <= reach; first = rows_.back().reach + 1)
      rows_.push_back({brick, first, std::min(reach, last_brick<d>(first)), first == near && near > 0});
    if (near > 0) rows_[head].parts = int(rows_.size() - head);
  });

  const auto sides =
      std::stable_partition(rows_.begin(), rows_.end(), [](const Row& row) { return row.near == 0; });
  middle_size_ = std::size_t(sides - rows_.begin());

  widths_.resize(std::size_t(Lines<d>::kCount) * rows_.size());
  met_.resize(widths_.size());
  for (int line = 0; line < Lines<d>::kCount; ++line)
    for (std::size_t row = 0; row < rows_.size(); ++row)
      for (int other = 0; other < Lines<d>::kCount; ++other) {
        const Row& own = rows_[row];
        const LatticePoint<d> z = Brick<d>::origin(own.brick) + Brick<d>::offset(other * kLength) -
                                  Brick<d>::offset(line * kLength);
        const int width =
            std::clamp(half_width(z) + kLength - own.base(), 0, (own.reach + 2 - own.near) * kLength);
        const std::size_t at = std::size_t(line) * rows_.size() + row;
        widths_[at].of[std::size_t(other)] = typename Lines<d>::Width(width);
        met_[at] |= half_width(z) >= skew_;
      }
}

template class BallRows<2>;
template class BallRows<3>;

}  // namespace gridstep::bricks
