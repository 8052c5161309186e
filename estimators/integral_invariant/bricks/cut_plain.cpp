#include "estimators/integral_invariant/bricks/cut_plain.hpp"

#include <algorithm>

#include "estimators/integral_invariant/bricks/brick_sums.hpp"

namespace gridstep::bricks {

namespace {

template <int d>
using Widths = typename Lines<d>::Widths;

/// The points of the lines of a brick beyond `from`, counted from its low end, or from its high end.
template <bool low>
Brick<2> ends(const Widths<2>& widths, int from) {
  Brick<2> result;
  for (std::size_t i = 0; i < 8; ++i) {
    const int none = std::clamp(64 + from - int(widths.of[i]), 0, 64);
    if (none < 64) result.words[i] = low ? ~std::uint64_t{0} >> none : ~std::uint64_t{0} << none;
  }
  return result;
}

/// The s = x - 256 lowest, or highest, bits of a byte, 0 <= s <= 8: a table instead of two comparisons and a shift.
template <bool low>
constexpr auto kEnd = [] {
  std::array<std::uint8_t, 512> table{};
  for (int x = 0; x < 512; ++x) {
    const int none = std::clamp(8 - (x - 256), 0, 8);
    table[std::size_t(x)] = std::uint8_t(low ? 255 >> none : 255 << none);
  }
  return table;
}();

template <bool low>
Brick<3> ends(const Widths<3>& widths, int from) {
  const std::uint8_t* const end = kEnd<low>.data() + 256 - from;
  Brick<3> result;
  for (std::size_t z = 0; z < 8; ++z)
    for (std::size_t y = 8; y-- > 0;) result.words[z] = result.words[z] << 8 | end[widths.of[8 * z + y]];
  return result;
}

/// For one spel.
template <int d, class Sum>
Sum cut_sum(const SourceLists<d, Sum>& lists, const AlignedBall<d>& ball) {
  constexpr int kLength = Lines<d>::kLength;
  const Widths<d>* const widths = ball.widths();
  const int to_right = ball.to_right(), to_left = ball.to_left();
  const auto origin = [&](std::uint32_t row, int offset) {
    LatticePoint<d> brick = ball.ball->rows()[row].brick;
    brick[0] = offset;
    return LatticePoint<d>(Brick<d>::origin(brick) - Brick<d>::offset(ball.bit));
  };
  const auto right = [&](const MixedBrick& e) { return ends<true>(widths[e.row], e.from + to_right); };
  const auto left = [&](const MixedBrick& e) { return ends<false>(widths[e.row], e.from + to_left); };
  Sum sum;
  const auto add_mixed = [&](const MixedBrick& entry, Brick<d> mask) {
    for (std::size_t i = 0; i < 8; ++i) mask.words[i] &= entry.words[i];
    add_brick(sum, mask, origin(entry.row, entry.offset));
  };
  for (const MixedBrick& entry : lists.right.mixed) add_mixed(entry, right(entry));
  for (const MixedBrick& entry : lists.left.mixed) add_mixed(entry, left(entry));
  for (const MixedBrick& entry : lists.middle) {
    Brick<d> both = right(entry);
    const Brick<d> other = left(entry);
    for (std::size_t i = 0; i < 8; ++i) both.words[i] &= other.words[i];
    add_mixed(entry, both);
  }

  const auto lengths = [&](const FullRun& run, int to, auto add_line) {
    for (int line = 0; line < Lines<d>::kCount; ++line)
      add_line(Brick<d>::offset(line * kLength),
               std::clamp(int(widths[run.row].of[std::size_t(line)]) - run.from - to, 0, int(run.length)));
  };
  for (const FullRun& run : lists.right.full)
    lengths(run, to_right, [&, first = origin(run.row, run.offset)](const LatticePoint<d>& line, int length) {
      add_stretch(sum, LatticePoint<d>(first + line), length);
    });
  for (const FullRun& run : lists.left.full)
    lengths(run, to_left, [&, end = origin(run.row, run.offset + 1)](const LatticePoint<d>& line, int length) {
      LatticePoint<d> first = end + line;
      first[0] -= length;
      add_stretch(sum, first, length);
    });
  return sum;
}

}  // namespace

template <int d, class Sum>
void cut_plain(const SourceLists<d, Sum>& lists, const BallRows<d>& ball, std::span<const std::uint16_t> bits,
               Sum* sums) {
  for (std::size_t i = 0; i < bits.size(); ++i) sums[i] = cut_sum(lists, AlignedBall<d>{&ball, bits[i]});
}

template void cut_plain(const SourceLists<2, Counts<2>>&, const BallRows<2>&, std::span<const std::uint16_t>,
                        Counts<2>*);
template void cut_plain(const SourceLists<3, Counts<3>>&, const BallRows<3>&, std::span<const std::uint16_t>,
                        Counts<3>*);
template void cut_plain(const SourceLists<3, Moments>&, const BallRows<3>&, std::span<const std::uint16_t>,
                        Moments*);

}  // namespace gridstep::bricks
