// Ten moments of the points that balls cut out of rows. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

using ShortTag = hn::Repartition<std::int16_t, ByteTag>;
using Shorts = hn::VFromD<ShortTag>;  // a line each, those with even y or those with odd y
// Ints have four lines each, of one z; Longs have eight: a slice, z fixed.

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
#if HWY_TARGET <= HWY_AVX3_DL
  // One instruction, which Highway 1.0 neither uses nor lets an intrinsic make.
  asm("vpdpwssd %2, %1, %0" : "+v"(sum.raw) : "v"(a.raw), "v"(b.raw));
  return sum;
#else
  Ints unused = hn::Zero(IntTag());
  return hn::ReorderWidenMulAccumulate(IntTag(), a, b, sum, unused);
#endif
}
HWY_INLINE Ints pairs(Shorts a, Shorts b) {
  return add_pairs(hn::Zero(IntTag()), a, b);
}
HWY_INLINE Longs slices(Ints v) {
  return hn::Add(hn::MulEven(v, hn::Set(IntTag(), 1)), hn::ShiftRight<32>(hn::BitCast(LongTag(), v)));
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

/// What depends on where a row of bricks lies. Its lines are taken in pairs, of y = 8 Y + 2 k and 8 Y + 2 k + 1.
struct RowWeights {
  using Pairs = std::array<std::int16_t, 4>;  // k = 0, ..., 3
  using Same = std::array<std::int16_t, 2>;
  Pairs y, yy, Zy;
  Same Y, Z, ZZ;
  std::int16_t base;

  explicit RowWeights(const BallRows<3>::Row& row) : base(std::int16_t(row.base())) {
    const int own_Y = row.brick[1], own_Z = row.brick[2];
    for (int k = 0; k < 4; ++k) {
      y[std::size_t(k)] = std::int16_t(8 * own_Y + 2 * k);
      yy[std::size_t(k)] = std::int16_t(own_Y * (2 * own_Y + k));
      Zy[std::size_t(k)] = std::int16_t(own_Z * (4 * own_Y + k));
    }
    const auto same = [](int a) { return Same{std::int16_t(a), std::int16_t(a)}; };
    Y = same(own_Y);
    Z = same(own_Z);
    ZZ = same(own_Z * own_Z);
  }
};
HWY_INLINE Shorts all(const RowWeights::Pairs& four) {
  return hn::BitCast(ShortTag(), hn::Set(LongTag(), std::bit_cast<std::int64_t>(four)));
}
HWY_INLINE Shorts all(const RowWeights::Same& two) {
  return hn::BitCast(ShortTag(), hn::Set(IntTag(), std::bit_cast<std::int32_t>(two)));
}
HWY_INLINE Shorts all(int value) {
  return hn::Set(ShortTag(), std::int16_t(value));
}
HWY_INLINE Bytes all_bytes(int even, int odd) {
  return hn::BitCast(ByteTag(), all(even | odd << 8));
}

/// A number for each line, of those with even y and of those with odd y.
struct EvenOdd {
  Shorts even, odd;
};
HWY_INLINE EvenOdd split(Bytes v) {
  const hn::RebindToUnsigned<ShortTag> tag;
  return {hn::And(hn::BitCast(ShortTag(), v), all(0xff)), hn::BitCast(ShortTag(), hn::ShiftRight<8>(hn::BitCast(tag, v)))};
}

/// The moments of one run in each line of one row after the other: of n points from x on, c = 2 x + n, that are
///   sum x = (n c - n) / 2,  sum x^2 = (3 n c^2 - 6 n c + n^3 + 2 n) / 12.
/// Positions are taken from the source brick.
class Accumulator {
 public:
  /// In the lanes from the at-th line of every brick on. An Int adds up four lines of each row: n^3 of at most 168^3, n c^2
  /// of at most 2^14 2 (radius + 16). A Short adds up n of two lines.
  Accumulator(int radius, std::size_t at)
      : z0_(int(at / 8)), most_rows_(std::min<std::size_t>(90, std::size_t(16384 / (radius + 16)))) {
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
  HWY_INLINE void add(const EvenOdd& n, const EvenOdd& c, const RowWeights& row) {
    const Shorts one = all(1), y = all(row.y), Y = all(row.Y), Z = all(row.Z);
    const Shorts both_n = hn::Add(n.even, n.odd);
    n_ = hn::Add(n_, both_n);
    odd_n_ = hn::Add(odd_n_, n.odd);
    y_ = add_pairs(y_, both_n, y);
    yy_ = add_pairs(yy_, both_n, all(row.yy));
    Zn_ = add_pairs(Zn_, both_n, Z);
    ZZn_ = add_pairs(ZZn_, both_n, all(row.ZZ));
    Zy_ = add_pairs(Zy_, both_n, all(row.Zy));
    odd_Yn_ = add_pairs(odd_Yn_, n.odd, Y);
    odd_Zn_ = add_pairs(odd_Zn_, n.odd, Z);
    nnn_ = add_pairs(add_pairs(nnn_, hn::Mul(n.even, n.even), n.even), hn::Mul(n.odd, n.odd), n.odd);

    const Shorts even_nc = hn::Mul(n.even, c.even), odd_nc = hn::Mul(n.odd, c.odd), both_nc = hn::Add(even_nc, odd_nc);
    nc_ = add_pairs(nc_, both_nc, one);
    odd_nc_ = add_pairs(odd_nc_, odd_nc, one);
    ync_ = add_pairs(ync_, both_nc, y);
    Znc_ = add_pairs(Znc_, both_nc, Z);
    ncc_ = add_pairs(add_pairs(ncc_, even_nc, c.even), odd_nc, c.odd);
  }
  HWY_INLINE Moments<3> sums() {
    spill();
    const auto& [n, nc, y, z, cubes, ync, znc, yy, yz, zz] = totals_;
    const auto number = [](std::int64_t v) { return std::uint64_t(v); };
    return {number(n),
            {number((nc - n) / 2), number(y), number(z)},
            {number((cubes - 6 * nc + 2 * n) / 12), number((ync - y) / 2), number((znc - z) / 2), number(yy), number(yz),
             number(zz)}};
  }

 private:
  HWY_INLINE void begin() {
    n_ = odd_n_ = hn::Zero(ShortTag());
    y_ = yy_ = Zn_ = ZZn_ = Zy_ = odd_Yn_ = odd_Zn_ = nc_ = odd_nc_ = ync_ = Znc_ = ncc_ = nnn_ = hn::Zero(IntTag());
    rows_ = 0;
  }
  HWY_INLINE void add_to_totals(std::size_t i, Longs a, Longs b) {
    const auto both =
        sum_of_pairs(hn::Add(hn::InterleaveLower(LongTag(), a, b), hn::InterleaveUpper(LongTag(), a, b)));
    const hn::DFromV<decltype(both)> tag;
    hn::Store(hn::Add(hn::Load(tag, &totals_[i]), both), tag, &totals_[i]);
  }
  /// Before a sum may leave its bits. With N points in a pair of lines, O of them on its odd line,
  ///   sum y = (8 Y + 2 k) N + O,  sum y^2 = 32 Y (2 Y + k) N + 16 Y O + 4 k^2 N + (4 k + 1) O.
  HWY_INLINE void spill() {
    static constexpr RowWeights::Pairs k4k{0, 4, 16, 36}, k4k1{1, 5, 9, 13};
    const Shorts one = all(1);
    const Longs z = hn::Iota(LongTag(), z0_);
    const Longs n = slices(pairs(n_, one)), odd_n = slices(pairs(odd_n_, one)),
                y = hn::Add(slices(y_), odd_n), Zn = hn::ShiftLeft<3>(slices(Zn_)), zn = times(n, z),
                nc = slices(nc_), ncc = slices(ncc_);
    add_to_totals(0, n, nc);
    add_to_totals(2, y, hn::Add(Zn, zn));
    add_to_totals(4, hn::Add(hn::Add(ncc, hn::Add(ncc, ncc)), slices(nnn_)), hn::Add(slices(ync_), slices(odd_nc_)));
    add_to_totals(6, hn::Add(hn::ShiftLeft<3>(slices(Znc_)), times(nc, z)),
                  hn::Add(hn::Add(hn::ShiftLeft<5>(slices(yy_)), hn::ShiftLeft<4>(slices(odd_Yn_))),
                          slices(add_pairs(pairs(n_, all(k4k)), odd_n_, all(k4k1)))));
    add_to_totals(8,
                  hn::Add(hn::Add(hn::ShiftLeft<4>(slices(Zy_)), hn::ShiftLeft<3>(slices(odd_Zn_))), times(y, z)),
                  hn::Add(hn::ShiftLeft<6>(slices(ZZn_)), times(hn::Add(hn::Add(Zn, Zn), zn), z)));
    begin();
  }

  int z0_;
  std::size_t most_rows_, rows_;
  Shorts n_, odd_n_;
  Ints y_, yy_, Zn_, ZZn_, Zy_, odd_Yn_, odd_Zn_, nc_, odd_nc_, ync_, Znc_, ncc_, nnn_;
  alignas(16) std::array<std::int64_t, 10> totals_{};  // in the order in which sums() names them
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

/// 2 x at the end of each run of a side that no ball cuts: c - n, or c + n on the left.
struct alignas(64) FixedEnds {
  std::array<std::int16_t, hn::MaxLanes(ShortTag())> even, odd;
};

template <bool mirrored>
void list_fixed_ends(const RowRuns<3>& side, std::span<const RowWeights> weights, std::vector<FixedEnds>& result) {
  const ShortTag tag;
  result.resize(side.size());
  for (std::size_t k = 0; k < side.size(); ++k) {
    const Bytes from = hn::Load(ByteTag(), side[k].begin.data());
    const Shorts even = pairs(from, all_bytes(2, 0)), odd = pairs(from, all_bytes(0, 2)),
                 base = all(2 * weights[side.row(k)].base);
    const auto end = [&](Shorts v) HWY_ATTR { return mirrored ? hn::Sub(hn::Sub(all(16), base), v) : hn::Add(base, v); };
    hn::Store(end(even), tag, result[k].even.data());
    hn::Store(end(odd), tag, result[k].odd.data());
  }
}

/// What the balls around the spels of a source brick may cut, and what does not depend on the spel.
struct CutMoments {
  CutRuns<3> runs;
  std::vector<RowWeights> weights;
  std::vector<std::uint32_t> middle;  // what list_met() gives for the line at hand
  std::vector<FixedEnds> right, left;
};

template <bool mirrored>
HWY_INLINE void add_side(Accumulator& sums, const RowRuns<3>& side, std::span<const FixedEnds> fixed,
                         std::span<const RowWeights> weights, const LineBalls<3, 1>& balls, Bytes to) {
  const ByteTag tag;
  const ShortTag short_tag;
  for (std::size_t k = 0; k < side.size(); sums.make_room())
    for (const std::size_t stop = sums.stop(k, side.size()); k < stop; ++k) {
      const std::uint32_t row = side.row(k);
      const EvenOdd n =
          split(hn::Min(beyond(beyond(balls.width(row), hn::Load(tag, side[k].begin.data())), to),
                        hn::Load(tag, side[k].end_or_length.data())));
      const Shorts even = hn::Load(short_tag, fixed[k].even.data()), odd = hn::Load(short_tag, fixed[k].odd.data());
      if constexpr (mirrored)
        sums.add(n, {hn::Sub(even, n.even), hn::Sub(odd, n.odd)}, weights[row]);
      else
        sums.add(n, {hn::Add(even, n.even), hn::Add(odd, n.odd)}, weights[row]);
    }
}

HWY_INLINE Moments<3> moments_of_spel(const CutMoments& cut, const BallRows<3>& ball, std::uint16_t bit,
                                      std::size_t at) {
  static_assert(RowRuns<3>::kMiddleOrigin == 128);
  const ByteTag tag;
  const LineBalls<3, 1> balls(ball, &bit, at);
  const auto& [runs, weights, middle, right, left] = cut;
  Accumulator sums(ball.radius(), at);
  for (std::size_t i = 0; i < middle.size(); sums.make_room())
    for (const std::size_t stop = sums.stop(i, middle.size()); i < stop; ++i) {
      const LineRuns<3>& own = runs.middle[middle[i]];
      const std::uint32_t row = runs.middle.row(middle[i]);
      const Bytes width = balls.width(row);
      const Bytes from = hn::Max(hn::Load(tag, own.begin.data()), hn::Sub(balls.left_end[0], width)),
                  to = hn::Min(hn::Load(tag, own.end_or_length.data()), hn::Add(width, balls.right_end[0]));
      const EvenOdd n = split(beyond(to, from));
      const Bytes x = hn::Xor(from, all_bytes(128, 128));  // signed
      sums.add(n, {hn::Add(pairs(all_bytes(2, 0), x), n.even), hn::Add(pairs(all_bytes(0, 2), x), n.odd)}, weights[row]);
    }
  add_side<false>(sums, runs.right, right, weights, balls, balls.to_right[0]);
  add_side<true>(sums, runs.left, left, weights, balls, balls.to_left[0]);
  return sums.sums();
}

void moments_3d(const SourceLists<3, Moments<3>>& lists, const BallRows<3>& ball,
                std::span<const std::uint16_t> bits, Moments<3>* sums) {
  thread_local CutMoments cut;
  cut.weights.clear();
  for (const auto& row : ball.rows()) cut.weights.emplace_back(row);
  std::fill(sums, sums + bits.size(), Moments<3>{});
  for (std::size_t at = 0; at < 64; at += hn::Lanes(ByteTag())) {
    cut.runs.list(lists, ball, at);
    list_fixed_ends<false>(cut.runs.right, cut.weights, cut.right);
    list_fixed_ends<true>(cut.runs.left, cut.weights, cut.left);
    for (std::size_t i = 0; i < bits.size(); ++i) {
      const int line = bits[i] / 8;
      if (i == 0 || bits[i - 1] / 8 != line) list_met(cut.runs.middle, ball.met(line), cut.middle);
      add(sums[i], moments_of_spel(cut, ball, bits[i], at));
    }
  }
}

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
