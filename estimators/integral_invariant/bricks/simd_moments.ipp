// Ten moments of the points that balls cut out of rows. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

using ShortTag = hn::Repartition<std::int16_t, ByteTag>;
using Shorts = hn::VFromD<ShortTag>;  // a line each, those with even y or those with odd y
using IntTag = hn::Repartition<std::int32_t, ByteTag>;
using Ints = hn::VFromD<IntTag>;  // four lines each, of one z
using SumTag = hn::Repartition<std::int64_t, ByteTag>;
using SliceSums = hn::VFromD<SumTag>;  // eight lines each: a slice, z fixed

/// The sums of products of neighbours, of bytes and of signed weights.
HWY_INLINE Shorts pairs(Bytes bytes, Bytes weights) {
#if HWY_TARGET <= HWY_AVX3
  return Shorts{_mm512_maddubs_epi16(bytes.raw, weights.raw)};
#else
  return Shorts{_mm256_maddubs_epi16(bytes.raw, weights.raw)};
#endif
}
/// sum + the sums of products of neighbours.
HWY_INLINE Ints add_pairs(Ints sum, Shorts a, Shorts b) {
  Ints unused = hn::Zero(IntTag());
  return hn::ReorderWidenMulAccumulate(IntTag(), a, b, sum, unused);
}
HWY_INLINE Ints pairs(Shorts a, Shorts b) {
  return add_pairs(hn::Zero(IntTag()), a, b);
}
HWY_INLINE SliceSums slices(Ints v) {
  return hn::Add(hn::MulEven(v, hn::Set(IntTag(), 1)), hn::ShiftRight<32>(hn::BitCast(SumTag(), v)));
}
/// Of numbers that fit 32 bits.
HWY_INLINE SliceSums times(SliceSums a, SliceSums b) {
  return hn::MulEven(hn::BitCast(IntTag(), a), hn::BitCast(IntTag(), b));
}

/// The sum of the pairs that a vector is made of.
template <class V>
HWY_INLINE auto sum_of_pairs(V v) {
  constexpr hn::DFromV<V> tag;
  if constexpr (hn::MaxLanes(tag) == 2) {
    return v;
  } else {
    const hn::Half<decltype(tag)> half;
    return sum_of_pairs(hn::Add(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  }
}

/// What depends on where a row of bricks lies: y = 8 Y + 0, ..., 7 and z = 8 Z + 0, ..., 7 in its lines.
struct RowWeights {
  using Pair = std::array<std::int16_t, 2>;
  std::array<std::int16_t, 4> even_y, odd_y;
  Pair Z;
  Pair y, yy, Zn, ZZn, Zy;  // of the number of points, and of their sum of y - 8 Y
  std::int32_t doubled_base;

  explicit RowWeights(const BallRows<3>::Row& row) : doubled_base(2 * row.base()) {
    const auto pair = [](int a, int b) { return Pair{std::int16_t(a), std::int16_t(b)}; };
    const int own_Y = row.brick[1], own_Z = row.brick[2];
    for (int i = 0; i < 4; ++i) {
      even_y[std::size_t(i)] = std::int16_t(8 * own_Y + 2 * i);
      odd_y[std::size_t(i)] = std::int16_t(8 * own_Y + 2 * i + 1);
    }
    Z = pair(own_Z, own_Z);
    y = pair(8 * own_Y, 1);
    yy = pair(4 * own_Y * own_Y, own_Y);  // y^2 = 16 (4 Y^2 + Y (y - 8 Y)) + (y - 8 Y)^2
    Zn = pair(own_Z, 0);
    ZZn = pair(own_Z * own_Z, 0);
    Zy = pair(8 * own_Y * own_Z, own_Z);
  }
};
HWY_INLINE Shorts all(const std::array<std::int16_t, 4>& four) {
  return hn::BitCast(ShortTag(), hn::Set(SumTag(), std::bit_cast<std::int64_t>(four)));
}
HWY_INLINE Shorts all(const std::array<std::int16_t, 2>& two) {
  return hn::BitCast(ShortTag(), hn::Set(IntTag(), std::bit_cast<std::int32_t>(two)));
}
HWY_INLINE Shorts all(int value) {
  return hn::Set(ShortTag(), std::int16_t(value));
}
HWY_INLINE Bytes all_bytes(int even, int odd) {
  return hn::BitCast(ByteTag(), all(even | odd << 8));
}

/// y - y0 for y = 0, ..., 7, and its square, as bytes of a word.
struct LineWeights {
  std::uint64_t y = 0, yy = 0;
};
constexpr auto kLineWeights = [] {
  std::array<LineWeights, 8> result;
  for (int y0 = 0; y0 < 8; ++y0)
    for (int y = 0; y < 8; ++y) {
      result[std::size_t(y0)].y |= std::uint64_t((y - y0) & 255) << (8 * y);
      result[std::size_t(y0)].yy |= std::uint64_t((y - y0) * (y - y0)) << (8 * y);
    }
  return result;
}();

/// The moments of one run in each line of one row after the other: of n points around c / 2 that are
///   sum x = n c / 2,  sum x^2 = (3 n c^2 + n^3 - n) / 12.
/// Positions are taken from a spel in `line` of the source brick.
class Accumulator {
 public:
  /// In the lanes from the at-th line of every brick on. An Int adds up four lines of each row: n^3 of at most 168^3, n c^2
  /// of at most 2^15 2 (radius + 8).
  Accumulator(int radius, int line, std::size_t at)
      : y0_(line % 8), z0_(int(at / 8) - line / 8), most_rows_(std::min<std::size_t>(90, std::size_t(8192 / (radius + 16)))) {
    const LineWeights& weights = kLineWeights[std::size_t(y0_)];
    own_y_weights_ = hn::BitCast(ByteTag(), hn::Set(WordTag(), weights.y));
    own_yy_weights_ = hn::BitCast(ByteTag(), hn::Set(WordTag(), weights.yy));
    begin();
  }

  /// Rows k to end are to be added: where to call make_room() between them, or `end`.
  HWY_INLINE std::size_t stop(std::size_t k, std::size_t end) {
    const std::size_t result = std::min(end, k + most_rows_ - rows_);
    rows_ += result - k;
    return result;
  }
  HWY_INLINE void make_room() {
    if (rows_ == most_rows_) spill();
  }
  /// c = 2 from + n - shift, or with the other sign.
  template <bool mirrored>
  HWY_INLINE void add(Bytes n, Bytes from, int shift, const RowWeights& row) {
    const Shorts one = all(1);
    const Shorts even_n = hn::And(hn::BitCast(ShortTag(), n), all(0xff)), odd_n = pairs(n, all_bytes(0, 1));
    const Shorts even_sum = hn::Add(pairs(from, all_bytes(2, 0)), even_n),
                 odd_sum = hn::Add(pairs(from, all_bytes(0, 2)), odd_n);
    const Shorts even_c = mirrored ? hn::Sub(all(shift), even_sum) : hn::Sub(even_sum, all(shift)),
                 odd_c = mirrored ? hn::Sub(all(shift), odd_sum) : hn::Sub(odd_sum, all(shift));
    const Shorts even_nc = hn::Mul(even_n, even_c), odd_nc = hn::Mul(odd_n, odd_c);
    const auto of_both = [&](Ints sum, Shorts even, Shorts odd)
                             HWY_ATTR { return add_pairs(add_pairs(sum, even_nc, even), odd_nc, odd); };
    nc_ = of_both(nc_, one, one);
    ync_ = of_both(ync_, all(row.even_y), all(row.odd_y));
    Znc_ = of_both(Znc_, all(row.Z), all(row.Z));
    ncc_ = of_both(ncc_, even_c, odd_c);
    nnn_ = add_pairs(add_pairs(nnn_, hn::Mul(even_n, even_n), even_n), hn::Mul(odd_n, odd_n), odd_n);

    const Ints own_n = pairs(pairs(n, all_bytes(1, 1)), one), own_y = pairs(pairs(n, own_y_weights_), one);
    n_ = hn::Add(n_, own_n);
    own_yy_ = add_pairs(own_yy_, pairs(n, own_yy_weights_), one);
    const Shorts both = hn::BitCast(ShortTag(), hn::Or(own_n, hn::ShiftLeft<16>(own_y)));
    y_ = add_pairs(y_, both, all(row.y));
    yy_ = add_pairs(yy_, both, all(row.yy));
    Zn_ = add_pairs(Zn_, both, all(row.Zn));
    ZZn_ = add_pairs(ZZn_, both, all(row.ZZn));
    Zy_ = add_pairs(Zy_, both, all(row.Zy));
  }
  HWY_INLINE Moments sums() {
    spill();
    const auto total = [&](std::size_t i) { return std::uint64_t(totals_[i]); };
    const std::uint64_t xy = total(kXY) - total(kX) * std::uint64_t(y0_);  // still doubled
    return {total(kN),
            {half(total(kX)), total(kY), total(kZ)},
            {std::uint64_t((totals_[kXX] - totals_[kN]) / 12), half(xy), half(total(kXZ)), total(kYY), total(kYZ),
             total(kZZ)}};
  }

 private:
  enum { kN, kX, kY, kZ, kXX, kXY, kXZ, kYY, kYZ, kZZ, kTotals };

  static std::uint64_t half(std::uint64_t even) { return std::uint64_t(std::int64_t(even) / 2); }
  HWY_INLINE void begin() {
    n_ = y_ = yy_ = own_yy_ = Zn_ = ZZn_ = Zy_ = nc_ = ync_ = Znc_ = ncc_ = nnn_ = hn::Zero(IntTag());
    rows_ = 0;
  }
  HWY_INLINE void add_to_totals(std::size_t i, SliceSums a, SliceSums b) {
    const auto both = sum_of_pairs(hn::Add(hn::InterleaveLower(SumTag(), a, b), hn::InterleaveUpper(SumTag(), a, b)));
    const hn::DFromV<decltype(both)> tag;
    hn::Store(hn::Add(hn::Load(tag, &totals_[i]), both), tag, &totals_[i]);
  }
  /// Before a sum may leave 32 bits.
  HWY_INLINE void spill() {
    const SliceSums z = hn::Iota(SumTag(), z0_);
    const SliceSums n = slices(n_), y = slices(y_), nc = slices(nc_), Zn = hn::ShiftLeft<3>(slices(Zn_)),
                    zn = times(n, z), ncc = slices(ncc_);
    add_to_totals(kN, n, nc);
    add_to_totals(kY, y, hn::Add(Zn, zn));
    add_to_totals(kXX, hn::Add(hn::Add(ncc, hn::Add(ncc, ncc)), slices(nnn_)), slices(ync_));
    add_to_totals(kXZ, hn::Add(hn::ShiftLeft<3>(slices(Znc_)), times(nc, z)),
                  hn::Add(hn::ShiftLeft<4>(slices(yy_)), slices(own_yy_)));
    add_to_totals(kYZ, hn::Add(hn::ShiftLeft<3>(slices(Zy_)), times(y, z)),
                  hn::Add(hn::ShiftLeft<6>(slices(ZZn_)), times(hn::Add(hn::Add(Zn, Zn), zn), z)));
    begin();
  }

  int y0_, z0_;
  Bytes own_y_weights_, own_yy_weights_;
  std::size_t most_rows_, rows_;
  Ints n_, y_, yy_, own_yy_, Zn_, ZZn_, Zy_, nc_, ync_, Znc_, ncc_, nnn_;
  alignas(16) std::int64_t totals_[kTotals] = {};
};

/// The numbers of the runs that balls around a line of the source brick may meet: many rows just touch some balls, and a
/// row of moments costs more than this list.
void list_met(const RowRuns<3>& runs, const std::uint8_t* met, std::vector<std::uint32_t>& result) {
  result.resize(runs.size());
  std::size_t size = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    result[size] = std::uint32_t(k);
    size += met[runs.row(k)];
  }
  result.resize(size);
}

/// On one side, where c = 2 from + n - shift + 2 base, mirrored on the left.
template <bool mirrored>
HWY_INLINE void add_side(Accumulator& sums, const RowRuns<3>& side, std::span<const RowWeights> weights,
                         const LineBalls<3, 1>& balls, Bytes to, int shift) {
  const ByteTag tag;
  for (std::size_t k = 0; k < side.size(); sums.make_room())
    for (const std::size_t stop = sums.stop(k, side.size()); k < stop; ++k) {
      const std::uint32_t row = side.row(k);
      const Bytes from = hn::Load(tag, side[k].begin.data());
      const Bytes length = hn::Min(hn::SaturatedSub(hn::SaturatedSub(balls.width(row), from), to),
                                   hn::Load(tag, side[k].end_or_length.data()));
      sums.add<mirrored>(length, from, shift - weights[row].doubled_base, weights[row]);
    }
}

HWY_INLINE Moments moments_of_spel(const CutRuns<3>& runs, std::span<const std::uint32_t> middle,
                                   std::span<const RowWeights> weights, const BallRows<3>& ball, std::uint16_t bit,
                                   std::size_t at) {
  const ByteTag tag;
  const LineBalls<3, 1> balls(ball, &bit, at);
  const int x = bit % 8;
  Accumulator sums(ball.radius(), bit / 8, at);
  for (std::size_t i = 0; i < middle.size(); sums.make_room())
    for (const std::size_t stop = sums.stop(i, middle.size()); i < stop; ++i) {
      const LineRuns<3>& own = runs.middle[middle[i]];
      const std::uint32_t row = runs.middle.row(middle[i]);
      const Bytes width = balls.width(row);
      const Bytes from = hn::Max(hn::Load(tag, own.begin.data()), hn::Sub(balls.left_end[0], width)),
                  to = hn::Min(hn::Load(tag, own.end_or_length.data()), hn::Add(width, balls.right_end[0]));
      sums.add<false>(hn::SaturatedSub(to, from), from, 1 + 2 * (RowRuns<3>::kMiddleOrigin + x), weights[row]);
    }
  add_side<false>(sums, runs.right, weights, balls, balls.to_right[0], 1 + 2 * x);
  add_side<true>(sums, runs.left, weights, balls, balls.to_left[0], 15 - 2 * x);
  return sums.sums();
}

void moments_3d(const SourceLists<3, Moments>& lists, const BallRows<3>& ball,
                std::span<const std::uint16_t> bits, Moments* sums) {
  thread_local CutRuns<3> runs;
  thread_local std::vector<RowWeights> weights;
  thread_local std::vector<std::uint32_t> middle;
  weights.clear();
  for (const auto& row : ball.rows()) weights.emplace_back(row);
  std::fill(sums, sums + bits.size(), Moments{});
  for (std::size_t at = 0; at < 64; at += hn::Lanes(ByteTag())) {
    runs.list(lists, ball, at);
    for (std::size_t i = 0; i < bits.size(); ++i) {
      const int line = bits[i] / 8;
      if (i == 0 || bits[i - 1] / 8 != line) list_met(runs.middle, ball.met(line), middle);
      add(sums[i], moments_of_spel(runs, middle, weights, ball, bits[i], at));
    }
  }
}

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
