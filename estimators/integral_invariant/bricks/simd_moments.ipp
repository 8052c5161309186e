// Ten moments of the points that a ball cuts out of M and F. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

// A slice of a brick, z fixed, is a word of 8 lines. Its sums are small, so they are kept in signed words of which
// a product reads the lower half.
using SumTag = hn::Repartition<std::int64_t, ByteTag>;
using SliceSums = hn::VFromD<SumTag>;
using HalfTag = hn::Repartition<std::int32_t, ByteTag>;
using ShortTag = hn::Repartition<std::uint16_t, ByteTag>;
using Shorts = hn::VFromD<ShortTag>;

HWY_INLINE SliceSums times(SliceSums a, SliceSums b) {
  return hn::MulEven(hn::BitCast(HalfTag(), a), hn::BitCast(HalfTag(), b));
}
HWY_INLINE SliceSums constant(std::int64_t value) {
  return hn::Set(SumTag(), value);
}
HWY_INLINE SliceSums sums_of_bytes(Bytes v) {
  return hn::BitCast(SumTag(), hn::SumsOf8(v));
}
HWY_INLINE SliceSums sums_of_shorts(Shorts v) {
  const hn::Repartition<std::uint32_t, ByteTag> pairs;
  const auto w = hn::BitCast(pairs, v);
  const auto sums =
      hn::BitCast(WordTag(), hn::Add(hn::And(w, hn::Set(pairs, 0xffffu)), hn::ShiftRight<16>(w)));
  const auto low = hn::And(sums, hn::Set(WordTag(), std::uint64_t{0xffffffffu}));
  return hn::BitCast(SumTag(), hn::Add(low, hn::ShiftRight<32>(sums)));
}

/// Sums over the points of a slice in coordinates of the brick, or of the run.
struct Local {
  SliceSums n, x, y, xx, xy, yy;
};

/// Eight numbers, one for each line y of a slice, as factors of its even and odd bytes.
struct LineWeights {
  Shorts even, odd;

  explicit LineWeights(std::array<std::uint16_t, 8> weight) {
    alignas(64) std::array<std::uint16_t, 32> evens{}, odds{};
    for (std::size_t i = 0; i < 32; ++i) {
      evens[i] = weight[2 * (i % 4)];
      odds[i] = weight[2 * (i % 4) + 1];
    }
    even = hn::Load(ShortTag(), evens.data());
    odd = hn::Load(ShortTag(), odds.data());
  }
  /// Of numbers whose weighted sums fit 16 bits.
  HWY_INLINE SliceSums of(Shorts even_numbers, Shorts odd_numbers) const {
    return sums_of_shorts(hn::Add(hn::Mul(even_numbers, even), hn::Mul(odd_numbers, odd)));
  }
  /// Of bytes.
  HWY_INLINE SliceSums of(Bytes numbers) const {
    const auto v = hn::BitCast(ShortTag(), numbers);
    return of(hn::And(v, hn::Set(ShortTag(), std::uint16_t{0x00ff})), hn::ShiftRight<8>(v));
  }
  /// Of bytes whose products are bytes. The odd ones stay in place: their products are those of the byte, times 256.
  HWY_INLINE SliceSums of_small(Bytes numbers) const {
    const auto v = hn::BitCast(ShortTag(), numbers);
    const auto evens = hn::And(v, hn::Set(ShortTag(), std::uint16_t{0x00ff})),
               odds = hn::And(v, hn::Set(ShortTag(), std::uint16_t{0xff00}));
    return sums_of_bytes(hn::BitCast(ByteTag(), hn::Or(hn::Mul(evens, even), hn::Mul(odds, odd))));
  }
};

struct Constants {
  LineWeights line{{0, 1, 2, 3, 4, 5, 6, 7}};
  LineWeights square{{0, 1, 4, 9, 16, 25, 36, 49}};
  Bytes nibble, count, low_x, high_x, low_xx, high_xx;

  Constants() {
    alignas(16) std::array<std::uint8_t, 16> counts{}, xs{}, xs4{}, xxs{}, xxs4{};
    for (unsigned bits = 0; bits < 16; ++bits)
      for (unsigned x = 0; x < 4; ++x)
        if (bits >> x & 1) {
          counts[bits] = std::uint8_t(counts[bits] + 1);
          xs[bits] = std::uint8_t(xs[bits] + x);
          xs4[bits] = std::uint8_t(xs4[bits] + x + 4);
          xxs[bits] = std::uint8_t(xxs[bits] + x * x);
          xxs4[bits] = std::uint8_t(xxs4[bits] + (x + 4) * (x + 4));
        }
    const ByteTag tag;
    nibble = hn::Set(tag, std::uint8_t{15});
    count = hn::LoadDup128(tag, counts.data());
    low_x = hn::LoadDup128(tag, xs.data());
    high_x = hn::LoadDup128(tag, xs4.data());
    low_xx = hn::LoadDup128(tag, xxs.data());
    high_xx = hn::LoadDup128(tag, xxs4.data());
  }
};

/// Sums over each line of a brick.
struct LineSums {
  Bytes n, x, xx;
};

HWY_INLINE LineSums line_sums(const Constants& k, Bytes bits) {
  const auto low = hn::And(bits, k.nibble);
  const auto high =
      hn::And(hn::BitCast(ByteTag(), hn::ShiftRight<4>(hn::BitCast(ShortTag(), bits))), k.nibble);
  const auto lookup = [&](Bytes of_low, Bytes of_high) HWY_ATTR {
    return hn::Add(hn::TableLookupBytes(of_low, low), hn::TableLookupBytes(of_high, high));
  };
  return {lookup(k.count, k.count), lookup(k.low_x, k.high_x), lookup(k.low_xx, k.high_xx)};
}

/// Lines that begin at x = 0 and go up, or down, `lengths` points.
HWY_INLINE Local sums_of_lengths(const Constants& k, Bytes lengths, bool down) {
  const ShortTag shorts;
  const auto s = hn::BitCast(shorts, lengths);
  const auto even = hn::And(s, hn::Set(shorts, std::uint16_t{0x00ff})), odd = hn::ShiftRight<8>(s);
  // j = s (s - 1) / 2 = 0 + ... + (s - 1) is at most 32385, and two of them fit 16 bits.
  const auto sum_to = [&](Shorts v) HWY_ATTR { return hn::ShiftRight<1>(hn::Sub(hn::Mul(v, v), v)); };
  const auto j_even = sum_to(even), j_odd = sum_to(odd);
  const hn::Repartition<std::uint32_t, ByteTag> pairs;
  const auto lower = hn::Set(pairs, 0xffffu);
  const auto j = hn::BitCast(pairs, hn::Add(j_even, j_odd));
  const auto j_0145 = hn::And(j, lower),
             j_2367 = hn::ShiftRight<16>(j);  // of lines 0, 1 and 4, 5; of the others
  const auto halves_sum = [&](auto v) HWY_ATTR {
    const auto w = hn::BitCast(WordTag(), v);
    return hn::BitCast(
        SumTag(), hn::Add(hn::And(w, hn::Set(WordTag(), std::uint64_t{0xffffffffu})), hn::ShiftRight<32>(w)));
  };
  const auto j_all = hn::Add(j_0145, j_2367);
  SliceSums x = halves_sum(j_all);
  // The number of a line in binary: sum of y j over its lines = sum over bits of 2^bit times the lines with the bit.
  const auto upper = hn::BitCast(SumTag(), hn::ShiftRight<32>(hn::BitCast(WordTag(), j_all)));
  SliceSums xy =
      hn::Add(hn::ShiftLeft<2>(upper), hn::Add(hn::ShiftLeft<1>(halves_sum(j_2367)), sums_of_shorts(j_odd)));
  // 0 + 1 + 4 + ... + (s - 1)^2 = j (2 s - 1) / 3; all sums below 2^32, so that the third may be a product.
  const auto thrice = [&](Shorts jj, Shorts v) HWY_ATTR {
    const auto a = hn::BitCast(pairs, jj);
    const auto b = hn::BitCast(pairs, hn::Sub(hn::Add(v, v), hn::Set(shorts, std::uint16_t{1})));
    return hn::Add(hn::Mul(hn::And(a, lower), hn::And(b, lower)),
                   hn::Mul(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b)));
  };
  const auto squares = hn::BitCast(pairs, halves_sum(hn::Add(thrice(j_even, even), thrice(j_odd, odd))));
  const SliceSums xx =
      hn::BitCast(SumTag(), hn::And(hn::BitCast(WordTag(), hn::Mul(squares, hn::Set(pairs, 0xaaaaaaabu))),
                                    hn::Set(WordTag(), std::uint64_t{0xffffffffu})));
  if (down) {
    x = hn::Neg(x);
    xy = hn::Neg(xy);
  }
  return {sums_of_bytes(lengths), x, k.line.of(even, odd), xx, xy, k.square.of(even, odd)};
}

/// Sums in coordinates of the source brick, entry by entry, slab by slab; a slab is the rows of one oz.
class Accumulator {
 public:
  explicit Accumulator(const Constants& k) : k_(k) {
    lines_n_ = lines_x_ = hn::Zero(ByteTag());
    n_ = x_ = y_ = xx_ = xy_ = yy_ = total_n_ = total_x_ = total_y_ = z_ = xz_ = yz_ = zz_ = constant(0);
  }

  /// Adds the bits of a brick that begins at (x0, y0) in the slab.
  HWY_INLINE void add(Bytes bits, int x0, int y0) {
    const LineSums lines = line_sums(k_, bits);
    // A brick's own xy and yy do not depend on where it lies: end_lines() takes them from nine bricks at once.
    add({sums_of_bytes(lines.n), sums_of_bytes(lines.x), k_.line.of_small(lines.n), sums_of_bytes(lines.xx),
         constant(0), constant(0)},
        x0, y0);
    lines_n_ = hn::Add(lines_n_, lines.n);
    lines_x_ = hn::Add(lines_x_, lines.x);
    if (++bricks_in_lines_ == 255 / 28) end_lines();
  }
  /// Adds sums whose origin is at (x0, y0) in the slab.
  HWY_INLINE void add(const Local& own, int x0, int y0) {
    const SliceSums X = constant(x0), Y = constant(y0);
    const SliceSums x = hn::Add(own.x, times(X, own.n)), y = hn::Add(own.y, times(Y, own.n));
    n_ = hn::Add(n_, own.n);
    x_ = hn::Add(x_, x);
    y_ = hn::Add(y_, y);
    xx_ = hn::Add(xx_, hn::Add(own.xx, times(X, hn::Add(own.x, x))));
    xy_ = hn::Add(xy_, hn::Add(own.xy, hn::Add(times(X, own.y), times(Y, x))));
    yy_ = hn::Add(yy_, hn::Add(own.yy, times(Y, hn::Add(own.y, y))));
  }
  /// Ends a slab: z is that of the first lane. The sums of a slab stay below 2^31 up to R/h = 900.
  HWY_INLINE void end_slab(int z0) {
    const SliceSums z = hn::Iota(SumTag(), z0), zz = times(z, z);
    total_n_ = hn::Add(total_n_, n_);
    total_x_ = hn::Add(total_x_, x_);
    total_y_ = hn::Add(total_y_, y_);
    z_ = hn::Add(z_, times(n_, z));
    xz_ = hn::Add(xz_, times(x_, z));
    yz_ = hn::Add(yz_, times(y_, z));
    zz_ = hn::Add(zz_, times(n_, zz));
    n_ = x_ = y_ = constant(0);
  }
  HWY_INLINE Moments sums() {
    end_lines();
    const auto all = [](SliceSums v)
                         HWY_ATTR { return std::uint64_t(hn::GetLane(hn::SumOfLanes(SumTag(), v))); };
    return {all(total_n_),
            {all(total_x_), all(total_y_), all(z_)},
            {all(xx_), all(xy_), all(xz_), all(yy_), all(yz_), all(zz_)}};
  }

 private:
  HWY_INLINE void end_lines() {
    xy_ = hn::Add(xy_, k_.line.of(lines_x_));
    yy_ = hn::Add(yy_, k_.square.of(lines_n_));
    lines_n_ = lines_x_ = hn::Zero(ByteTag());
    bricks_in_lines_ = 0;
  }

  const Constants& k_;
  Bytes lines_n_, lines_x_;  // bricks one upon the other: at most 8 and 28 for each
  int bricks_in_lines_ = 0;
  SliceSums n_, x_, y_, xx_, xy_, yy_;  // of the slab; the last three of all slabs
  SliceSums total_n_, total_x_, total_y_, z_, xz_, yz_, zz_;
};

/// The sums over the slices of one vector, `at` bytes into every brick.
HWY_INLINE Moments sums_of_slices(const SourceLists<3, Moments>& lists, const AlignedBall<3>& ball,
                                  const Constants& k, std::size_t at) {
  const auto bit = std::uint16_t(ball.bit);
  const LineBalls<1> balls(*ball.ball, &bit, at);
  const auto& rows = ball.ball->rows();
  Accumulator sums(k);

  const auto add_mixed = [&](auto& cuts, const std::vector<MixedBrick>& entries, std::uint32_t end) HWY_ATTR {
    while (cuts.entry != entries.data() + entries.size() && cuts.entry->row < end) {
      const MixedBrick& entry = *cuts.entry;
      const Cut<1> cut = cuts.next();
      sums.add(hn::And(cut.bits, cut.masks.of[0]), 8 * entry.offset, 8 * rows[entry.row].brick[1]);
    }
  };
  const auto add_full = [&](const std::vector<FullRun>& runs, std::size_t& next, std::uint32_t end,
                            bool down) HWY_ATTR {
    for (; next < runs.size() && runs[next].row < end; ++next) {
      const FullRun& run = runs[next];
      const Bytes beyond = balls.beyond(run.row, run.from + (down ? balls.skew : 0));
      const Bytes lengths = balls.lengths(beyond, down ? balls.to_left[0] : balls.to_right[0], run);
      sums.add(sums_of_lengths(k, lengths, down), 8 * run.offset + (down ? 7 : 0),
               8 * rows[run.row].brick[1]);
    }
  };
  Cuts<1, true, false> right{balls, lists.right.mixed.data()};
  Cuts<1, false, true> left{balls, lists.left.mixed.data()};
  Cuts<1, true, true> middle{balls, lists.middle.data()};
  std::array<std::size_t, 2> next{};
  for (std::uint32_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    const int slab = rows[begin].brick[2];
    while (end < rows.size() && rows[end].brick[2] == slab) ++end;
    add_mixed(right, lists.right.mixed, end);
    add_mixed(left, lists.left.mixed, end);
    add_mixed(middle, lists.middle, end);
    add_full(lists.right.full, next[0], end, false);
    add_full(lists.left.full, next[1], end, true);
    sums.end_slab(8 * slab + int(at / 8));
  }
  return sums.sums();
}

void moments_3d(const SourceLists<3, Moments>& lists, const BallRows<3>& ball,
                std::span<const std::uint16_t> bits, Moments* sums) {
  const Constants k;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    sums[i] = {};
    for (std::size_t at = 0; at < 64; at += hn::Lanes(ByteTag()))
      add(sums[i], sums_of_slices(lists, {&ball, bits[i]}, k, at));
    sums[i].move(Brick<3>::offset(bits[i]));
  }
}

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
