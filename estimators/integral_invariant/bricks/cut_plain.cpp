#include "estimators/integral_invariant/bricks/cut_plain.hpp"

#include <algorithm>
#include <cstdlib>

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

template <int d>
void intersect(Brick<d>& brick, const Brick<d>& other) {
  for (std::size_t i = 0; i < 8; ++i) brick.words[i] &= other.words[i];
}

/// For one spel, brick by brick.
template <int d, class Sum>
Sum cut_sum(const SourceLists<d, Sum>& lists, const AlignedBall<d>& ball) {
  static const Brick<d> kFull = Brick<d>::full();
  Sum sum;
  for (const auto* parts : {&lists.rows, &lists.right, &lists.left})
    for (const CutRow<d, Sum>& part : parts->cut) {
      const auto& row = ball.ball->rows()[part.row];
      const Widths<d>& widths = ball.widths()[part.row];
      lists.for_each_run(part, [&](int begin, int end, const Brick<d>* mixed) {
        LatticePoint<d> at = row.brick;
        for (at[0] = begin; at[0] < end; ++at[0]) {
          const int from = std::abs(at[0]) * Lines<d>::kLength - row.base();
          Brick<d> bits = mixed ? *mixed : kFull;
          if (at[0] >= 0) intersect(bits, ends<true>(widths, from + ball.to_right()));
          if (at[0] <= 0) intersect(bits, ends<false>(widths, from + ball.to_left()));
          add_brick(sum, bits, Brick<d>::origin(at));
        }
      });
    }
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
template void cut_plain(const SourceLists<2, Moments<2>>&, const BallRows<2>&, std::span<const std::uint16_t>,
                        Moments<2>*);
template void cut_plain(const SourceLists<3, Counts<3>>&, const BallRows<3>&, std::span<const std::uint16_t>,
                        Counts<3>*);
template void cut_plain(const SourceLists<3, Moments<3>>&, const BallRows<3>&, std::span<const std::uint16_t>,
                        Moments<3>*);

}  // namespace gridstep::bricks
