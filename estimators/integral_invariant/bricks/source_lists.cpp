#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

namespace {

void extend(std::vector<FullHalfRows>& half_rows, std::uint32_t row) {
  if (!half_rows.empty() && half_rows.back().end == row)
    ++half_rows.back().end;
  else
    half_rows.push_back({row, row + 1});
}

/// Lists what lies in bricks lo to hi along x, all on one side of brick `source`.
template <class Side, class Run>
void list_half_row(Side& side, const Run* run, int lo, int hi, int source, std::uint32_t row, int base,
                   int line_length) {
  if (lo > hi || (!run->mixed && run->begin <= lo && run->end > hi)) {
    extend(side.half_rows, row);
    return;
  }
  const auto from = [&](int offset) { return std::uint16_t(std::abs(offset) * line_length - base); };
  for (; run->begin <= hi; ++run) {
    if (run->mixed) {
      const int offset = run->begin - source;
      side.mixed.push_back({run->mixed->words.data(), row, from(offset), std::int16_t(offset)});
      continue;
    }
    const int begin = std::max(run->begin, lo), end = std::min(run->end, hi + 1);
    const int offset = lo > source ? begin - source : end - 1 - source;
    side.full.push_back(
        {row, from(offset), std::uint16_t((end - begin) * line_length), std::int16_t(offset)});
  }
}

}  // namespace

template <int d, class Sum>
void SourceLists<d, Sum>::build(const BallRows<d>& ball, const BrickRows<d, Sum>& set,
                                const LatticePoint<d>& source) {
  static const Brick<d> kFullBrick = Brick<d>::full();
  constexpr int kLength = Lines<d>::kLength;
  inside = {};
  middle.clear();
  for (Side* side : {&right, &left}) {
    side->mixed.clear();
    side->full.clear();
    side->half_rows.clear();
  }
  const int x = source[0];
  for (std::uint32_t index = 0; index < ball.rows().size(); ++index) {
    const auto& ball_row = ball.rows()[index];
    const LatticePoint<d> brick = source + ball_row.brick;
    const auto row = set.row(brick);
    if (row.empty()) continue;
    if (ball_row.whole >= 0) {
      const int begin = x - ball_row.whole, end = x + ball_row.whole + 1;
      add(inside, set.before(set.find(row, end), brick, end));
      subtract(inside, set.before(set.find(row, begin), brick, begin));
    } else if (const auto* run = set.find(row, x); run->begin <= x) {
      const Brick<d>& bits = run->mixed ? *run->mixed : kFullBrick;
      middle.push_back({bits.words.data(), index, 0, 0});
    }
    const int near = std::max(ball_row.whole + 1, 1), far = ball_row.reach;
    list_half_row(right, set.find(row, x + near), x + near, x + far, x, index, ball_row.base(), kLength);
    list_half_row(left, set.find(row, x - far), x - far, x - near, x, index, ball_row.base(), kLength);
  }
}

template struct SourceLists<2, Counts<2>>;
template struct SourceLists<3, Counts<3>>;
template struct SourceLists<3, Moments>;

}  // namespace gridstep::bricks
