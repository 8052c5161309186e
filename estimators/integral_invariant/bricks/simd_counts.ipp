// The number of points that balls cut out of rows. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

HWY_INLINE Words sums(Bytes v) {
  return hn::SumsOf8(v);
}
HWY_INLINE Words sums(Longs v) {
  return hn::BitCast(WordTag(), v);
}

/// On one side.
template <int d, std::size_t N>
HWY_INLINE void count_side(const RowRuns<d>& side, const LineBalls<d, N>& balls, const LineVector<d> (&to)[N],
                           Words (&totals)[N]) {
  const LineTag<d> tag;
  // So many numbers of points a lane is sure to hold.
  constexpr std::size_t kAtOnce = d == 3 ? 255 / (8 * BallRows<3>::kMostBricks) : 16;
  for (std::size_t k = 0; k < side.size();) {
    LineVector<d> some[N];
    for (auto& one : some) one = hn::Zero(tag);
    for (const std::size_t stop = std::min(side.size(), k + kAtOnce); k < stop; ++k) {
      const auto reached = beyond(balls.width(side.row(k)), hn::Load(tag, side[k].begin.data())),
                 length = hn::Load(tag, side[k].end_or_length.data());
      for (std::size_t i = 0; i < N; ++i)
        some[i] = hn::Add(some[i], hn::Min(beyond(reached, to[i]), length));
    }
    for (std::size_t i = 0; i < N; ++i) totals[i] = hn::Add(totals[i], sums(some[i]));
  }
}

/// For N spels of one line, in the lanes from the at-th line of every brick on.
template <int d, std::size_t N>
HWY_INLINE void count_line(const CutRuns<d>& runs, const BallRows<d>& ball, const std::uint16_t* bits, std::size_t at,
                           Counts<d>* counts) {
  const LineTag<d> tag;
  const LineBalls<d, N> balls(ball, bits, at);
  Words totals[N];
  for (Words& total : totals) total = hn::Zero(WordTag());
  for (std::size_t k = 0; k < runs.middle.size(); ++k) {
    const auto width = balls.width(runs.middle.row(k)), begin = hn::Load(tag, runs.middle[k].begin.data()),
               end = hn::Load(tag, runs.middle[k].end_or_length.data());
    for (std::size_t i = 0; i < N; ++i)
      totals[i] = hn::Add(totals[i], sums(beyond(hn::Min(end, hn::Add(width, balls.right_end[i])),
                                                 hn::Max(begin, hn::Sub(balls.left_end[i], width)))));
  }
  count_side(runs.right, balls, balls.to_right, totals);
  count_side(runs.left, balls, balls.to_left, totals);
  for (std::size_t i = 0; i < N; ++i) counts[i].n += hn::GetLane(hn::SumOfLanes(WordTag(), totals[i]));
}

template <int d>
HWY_INLINE void count(const SourceLists<d, Counts<d>>& lists, const BallRows<d>& ball,
                      std::span<const std::uint16_t> bits, Counts<d>* counts) {
  constexpr int kLength = Lines<d>::kLength;
  thread_local CutRuns<d> runs;
  std::fill(counts, counts + bits.size(), Counts<d>{});
  for (std::size_t at = 0; at < std::size_t(Lines<d>::kCount); at += hn::Lanes(LineTag<d>())) {
    runs.list(lists, ball, at);
    for (std::size_t i = 0; i < bits.size();) {
      std::size_t n = 1;
      while (n < 4 && i + n < bits.size() && bits[i + n] / kLength == bits[i] / kLength) ++n;
      switch (n) {
        case 4:
          count_line<d, 4>(runs, ball, &bits[i], at, counts + i);
          break;
        case 3:
          count_line<d, 3>(runs, ball, &bits[i], at, counts + i);
          break;
        case 2:
          count_line<d, 2>(runs, ball, &bits[i], at, counts + i);
          break;
        default:
          count_line<d, 1>(runs, ball, &bits[i], at, counts + i);
      }
      i += n;
    }
  }
}

void count_2d(const SourceLists<2, Counts<2>>& lists, const BallRows<2>& ball,
              std::span<const std::uint16_t> bits, Counts<2>* counts) {
  count<2>(lists, ball, bits, counts);
}
void count_3d(const SourceLists<3, Counts<3>>& lists, const BallRows<3>& ball,
              std::span<const std::uint16_t> bits, Counts<3>* counts) {
  count<3>(lists, ball, bits, counts);
}

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
