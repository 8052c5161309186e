#include "estimators/integral_invariant/bricks/cut_plain.hpp"

#include "estimators/integral_invariant/bricks/brick_sums.hpp"

namespace gridstep::bricks {

namespace {

/// Number of points of each line of a brick, or of a run of full bricks, that the ball reaches.
template <int d>
class Reach {
 public:
  explicit Reach(const AlignedBall<d>& ball)
      : widths_(ball.widths()), to_right_(ball.to_right()), to_left_(ball.to_left()) {}

  /// On the right, or the left, of the source brick; `from` and `most` are those of the entry.
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
Sum cut_plain(const SourceLists<d, Sum>& lists, const AlignedBall<d>& ball) {
  constexpr int kLength = Lines<d>::kLength;
  const Reach<d> reach(ball);
  const auto origin = [&](std::uint32_t row, int offset) {
    LatticePoint<d> brick = ball.ball->rows()[row].brick;
    brick[0] = offset;
    return LatticePoint<d>(Brick<d>::origin(brick) - Brick<d>::offset(ball.bit));
  };
  const auto whole_line = [](std::size_t) { return kLength; };
  Sum sum;
  const auto add_mixed = [&](const std::vector<MixedBrick>& entries, auto right, auto left) {
    for (const MixedBrick& entry : entries)
      add_brick(sum, cut<d>(entry, right(entry), left(entry)), origin(entry.row, entry.offset));
  };
  const auto cut_right = [&](const MixedBrick& entry) {
    return [&](std::size_t line) { return reach.right(entry.row, line, entry.from, kLength); };
  };
  const auto cut_left = [&](const MixedBrick& entry) {
    return [&](std::size_t line) { return reach.left(entry.row, line, entry.from, kLength); };
  };
  const auto not_cut = [&](const MixedBrick&) { return whole_line; };
  add_mixed(lists.right.mixed, cut_right, not_cut);
  add_mixed(lists.left.mixed, not_cut, cut_left);
  add_mixed(lists.middle, cut_right, cut_left);

  for (const FullRun& run : lists.right.full) {
    const LatticePoint<d> first = origin(run.row, run.offset);
    for (int line = 0; line < Lines<d>::kCount; ++line)
      add_stretch(sum, LatticePoint<d>(first + Brick<d>::offset(line * kLength)),
                  reach.right(run.row, std::size_t(line), run.from, run.length));
  }
  for (const FullRun& run : lists.left.full) {
    const LatticePoint<d> end = origin(run.row, run.offset + 1);
    for (int line = 0; line < Lines<d>::kCount; ++line) {
      const int length = reach.left(run.row, std::size_t(line), run.from, run.length);
      LatticePoint<d> first = end + Brick<d>::offset(line * kLength);
      first[0] -= length;
      add_stretch(sum, first, length);
    }
  }
  return sum;
}

template Counts<2> cut_plain(const SourceLists<2, Counts<2>>&, const AlignedBall<2>&);
template Counts<3> cut_plain(const SourceLists<3, Counts<3>>&, const AlignedBall<3>&);
template Moments cut_plain(const SourceLists<3, Moments>&, const AlignedBall<3>&);

}  // namespace gridstep::bricks
