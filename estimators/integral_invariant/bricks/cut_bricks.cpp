#include "estimators/integral_invariant/bricks/cut_bricks.hpp"

#include "estimators/integral_invariant/bricks/brick_sums.hpp"

namespace gridstep::bricks {

namespace {

/// The ball around one spel of the source brick.
template <int d>
class AlignedBall {
 public:
  static constexpr int kLength = Lines<d>::kLength;

  AlignedBall(const BallRows<d>& ball, int bit)
      : widths_(ball.widths(bit / kLength)),
        to_right_(kLength - 1 - bit % kLength),
        to_left_(bit % kLength + ball.skew()) {}

  /// Number of points of each line of a row, right or left, from `from` on, at most `most`.
  int right(std::uint32_t row, std::size_t line, int from, int most) const {
    return length(row, line, from + to_right_, most);
  }
  int left(std::uint32_t row, std::size_t line, int from, int most) const {
    return length(row, line, from + to_left_, most);
  }

 private:
  int length(std::uint32_t row, std::size_t line, int from, int most) const {
    return std::clamp(int(widths_[row].of[line]) - from, 0, most);
  }

  const typename Lines<d>::Widths* widths_;
  int to_right_, to_left_;
};

/// The points of a brick that are in the ball: length(line) of them at one end of each line.
template <int d, class LowLength, class HighLength>
Brick<d> cut(const MixedBrick& brick, LowLength low, HighLength high) {
  constexpr int kLength = Lines<d>::kLength;
  constexpr std::uint64_t kLine = ~std::uint64_t{0} >> (64 - kLength);
  Brick<d> result;
  for (std::size_t w = 0, line = 0; w < 8; ++w) {
    std::uint64_t mask = 0;
    for (int shift = 0; shift < 64; shift += kLength, ++line) {
      const int from_low = low(line), from_high = high(line);
      const std::uint64_t low_part = from_low == 0 ? 0 : kLine >> (kLength - from_low);
      const std::uint64_t high_part = from_high == 0 ? 0 : kLine << (kLength - from_high) & kLine;
      mask |= (low_part & high_part) << shift;
    }
    result.words[w] = brick.words[w] & mask;
  }
  return result;
}

}  // namespace

template <int d, class Sum>
Sum cut_sum(const SourceLists<d, Sum>& lists, const BallRows<d>& ball, int bit) {
  constexpr int kLength = Lines<d>::kLength;
  const AlignedBall<d> aligned(ball, bit);
  const auto origin = [&](std::uint32_t row, int offset) {
    LatticePoint<d> brick = ball.rows()[row].brick;
    brick[0] = offset;
    return LatticePoint<d>(Brick<d>::origin(brick) - Brick<d>::offset(bit));
  };
  const auto whole_line = [](std::size_t) { return kLength; };
  Sum sum;
  const auto add_mixed = [&](const std::vector<MixedBrick>& entries, auto right, auto left) {
    for (const MixedBrick& entry : entries)
      add_brick(sum, cut<d>(entry, right(entry), left(entry)), origin(entry.row, entry.offset));
  };
  const auto cut_right = [&](const MixedBrick& entry) {
    return [&](std::size_t line) { return aligned.right(entry.row, line, entry.from, kLength); };
  };
  const auto cut_left = [&](const MixedBrick& entry) {
    return [&](std::size_t line) { return aligned.left(entry.row, line, entry.from, kLength); };
  };
  const auto not_cut = [&](const MixedBrick&) { return whole_line; };
  add_mixed(lists.right.mixed, cut_right, not_cut);
  add_mixed(lists.left.mixed, not_cut, cut_left);
  add_mixed(lists.middle, cut_right, cut_left);

  for (const FullRun& run : lists.right.full) {
    const LatticePoint<d> first = origin(run.row, run.offset);
    for (int line = 0; line < Lines<d>::kCount; ++line)
      add_stretch(sum, LatticePoint<d>(first + Brick<d>::offset(line * kLength)),
                  aligned.right(run.row, std::size_t(line), run.from, run.length));
  }
  for (const FullRun& run : lists.left.full) {
    const LatticePoint<d> end = origin(run.row, run.offset + 1);
    for (int line = 0; line < Lines<d>::kCount; ++line) {
      const int length = aligned.left(run.row, std::size_t(line), run.from, run.length);
      LatticePoint<d> first = end + Brick<d>::offset(line * kLength);
      first[0] -= length;
      add_stretch(sum, first, length);
    }
  }
  return sum;
}

template PlainSum<2, std::uint64_t> cut_sum(const SourceLists<2, PlainSum<2, std::uint64_t>>&,
                                            const BallRows<2>&, int);
template PlainSum<3, std::uint64_t> cut_sum(const SourceLists<3, PlainSum<3, std::uint64_t>>&,
                                            const BallRows<3>&, int);
template MomentSums<3, std::uint64_t> cut_sum(const SourceLists<3, MomentSums<3, std::uint64_t>>&,
                                              const BallRows<3>&, int);

}  // namespace gridstep::bricks
