// Six moments of the points that disks cut out of rows. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

HWY_INLINE Longs all_longs(int value) {
  return hn::Set(LongTag(), value);
}

/// The moments of one run in each line of one row after the other, as in simd_moments_3d.ipp: of n points from x on, with
/// c = 2 x + n. Here each line has 64 bits to itself, and all factors fit 32: nothing needs to be spilled. Positions are
/// taken from the source brick.
class DiskAccumulator {
 public:
  /// `lines`: the y of the lines at hand in the bricks of row 0.
  explicit DiskAccumulator(Longs lines) : lines_(lines) {
    n_ = nc_ = ncc_ = nnn_ = y_ = yy_ = ync_ = hn::Zero(LongTag());
  }

  HWY_INLINE void add(Longs n, Longs c, const BallRows<2>::Row& row) {
    const Longs y = hn::Add(lines_, all_longs(row.brick[1] * Lines<2>::kCount));
    const Longs nc = times(n, c), ny = times(n, y);
    n_ = hn::Add(n_, n);
    nc_ = hn::Add(nc_, nc);
    ncc_ = hn::Add(ncc_, times(nc, c));
    nnn_ = hn::Add(nnn_, times(times(n, n), n));
    y_ = hn::Add(y_, ny);
    yy_ = hn::Add(yy_, times(ny, y));
    ync_ = hn::Add(ync_, times(nc, y));
  }
  HWY_INLINE Moments<2> sums() const {
    const std::int64_t n = total(n_), nc = total(nc_), y = total(y_);
    const auto number = [](std::int64_t v) { return std::uint64_t(v); };
    return {number(n),
            {number((nc - n) / 2), number(y)},
            {number((3 * total(ncc_) + total(nnn_) - 6 * nc + 2 * n) / 12), number((total(ync_) - y) / 2),
             number(total(yy_))}};
  }

 private:
  static HWY_INLINE std::int64_t total(Longs v) { return hn::GetLane(hn::SumOfLanes(LongTag(), v)); }

  Longs lines_, n_, nc_, ncc_, nnn_, y_, yy_, ync_;
};

template <bool mirrored>
HWY_INLINE void add_side(DiskAccumulator& sums, const RowRuns<2>& side, const BallRows<2>& ball,
                         const LineBalls<2, 1>& balls, Longs to) {
  for (std::size_t k = 0; k < side.size(); ++k) {
    const std::uint32_t i = side.row(k);
    const BallRows<2>::Row& row = ball.rows()[i];
    const Longs begin = hn::Load(LongTag(), side[k].begin.data());
    const Longs n = hn::Min(beyond(beyond(balls.width(i), begin), to),
                            hn::Load(LongTag(), side[k].end_or_length.data())),
                distance = hn::Add(all_longs(row.base()), begin);
    if constexpr (mirrored) {
      const Longs end = hn::Sub(all_longs(Lines<2>::kLength), distance);
      sums.add(n, hn::Sub(hn::Add(end, end), n), row);
    } else {
      sums.add(n, hn::Add(hn::Add(distance, distance), n), row);
    }
  }
}

HWY_INLINE Moments<2> moments_of_spel(const CutRuns<2>& runs, const BallRows<2>& ball, std::uint16_t bit,
                                      std::size_t at, Longs lines) {
  const LineBalls<2, 1> balls(ball, &bit, at);
  DiskAccumulator sums(lines);
  for (std::size_t k = 0; k < runs.middle.size(); ++k) {
    const LineRuns<2>& own = runs.middle[k];
    const std::uint32_t i = runs.middle.row(k);
    const Longs width = balls.width(i);
    const Longs from = hn::Max(hn::Load(LongTag(), own.begin.data()), hn::Sub(balls.left_end[0], width)),
                to = hn::Min(hn::Load(LongTag(), own.end_or_length.data()),
                             hn::Add(width, balls.right_end[0]));
    const Longs n = beyond(to, from), x = hn::Sub(from, all_longs(RowRuns<2>::kMiddleOrigin));
    sums.add(n, hn::Add(hn::Add(x, x), n), ball.rows()[i]);
  }
  add_side<false>(sums, runs.right, ball, balls, balls.to_right[0]);
  add_side<true>(sums, runs.left, ball, balls, balls.to_left[0]);
  return sums.sums();
}

void moments_2d(const SourceLists<2, Moments<2>>& lists, const BallRows<2>& ball,
                std::span<const std::uint16_t> bits, Moments<2>* sums) {
  thread_local CutRuns<2> runs;
  std::fill(sums, sums + bits.size(), Moments<2>{});
  for (std::size_t at = 0; at < std::size_t(Lines<2>::kCount); at += hn::Lanes(LongTag())) {
    runs.list(lists, ball, at);
    const Longs lines = hn::Iota(LongTag(), std::int64_t(at));
    for (std::size_t i = 0; i < bits.size(); ++i)
      add(sums[i], moments_of_spel(runs, ball, bits[i], at, lines));
  }
}

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
