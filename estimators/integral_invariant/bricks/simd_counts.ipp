// What balls cut out of M, and the number of points that they cut out of M and F. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

/// A vector for each of N spels that lie in one line of the source brick, and so share their balls' half-widths.
template <std::size_t N>
struct Group {
  Bytes of[N];
};

/// The bits of a brick, and for each ball of a group a mask of the points in that ball.
template <std::size_t N>
struct Cut {
  Bytes bits;
  Group<N> masks;
};

/// sum ^ (bits & mask).
HWY_INLINE Bytes toggled(Bytes sum, Bytes bits, Bytes mask) {
#if HWY_TARGET <= HWY_AVX3
  return Bytes{_mm512_ternarylogic_epi64(sum.raw, bits.raw, mask.raw, 0x78)};
#else
  return hn::Xor(sum, hn::And(bits, mask));
#endif
}

/// Bit by bit, whether at least two of three are set: `before` was added to one, which gave `between`, and to another,
/// which gave `after`.
HWY_INLINE Bytes carried(Bytes before, Bytes between, Bytes after) {
#if HWY_TARGET <= HWY_AVX3
  return Bytes{_mm512_ternarylogic_epi64(between.raw, after.raw, before.raw, 0x3a)};
#else
  return hn::Or(hn::AndNot(after, between), hn::AndNot(between, before));
#endif
}

/// Counts the bits of many vectors, byte by byte. Full adders, a bit each, leave one vector in eight to be counted
/// (R. Harley, W. Seal).
template <std::size_t N>
class BitCounter {
 public:
  BitCounter() {
    for (std::size_t i = 0; i < N; ++i) {
      ones_.of[i] = twos_.of[i] = fours_.of[i] = eights_.of[i] = rest_.of[i] = hn::Zero(ByteTag());
      total_[i] = hn::Zero(WordTag());
    }
  }
  template <class Source>
  HWY_INLINE void add_eight(Source& source) {
    const Group<N> a = add_four(source), b = add_four(source), eight = add(fours_, a, b);
    for (std::size_t i = 0; i < N; ++i)
      eights_.of[i] = hn::Add(eights_.of[i], hn::PopulationCount(eight.of[i]));
    if (++blocks_ == 255 / 8) spill_eights();
  }
  /// Fewer than eight; at most three times in all.
  template <class Source>
  HWY_INLINE void add_rest(Source& source, std::size_t count) {
    if (count & 4) add_to_rest<2>(add_four(source));
    if (count & 2) add_to_rest<1>(add_two(source));
    if (count & 1) {
      const Cut<N> one = source.next();
      Group<N> bits;
      for (std::size_t i = 0; i < N; ++i) bits.of[i] = hn::And(one.bits, one.masks.of[i]);
      add_to_rest<0>(bits);
    }
  }
  HWY_INLINE Words total(std::size_t i) {
    spill_eights();
    Bytes few = hn::PopulationCount(fours_.of[i]);
    few = hn::Add(hn::Add(few, few), hn::PopulationCount(twos_.of[i]));
    few = hn::Add(hn::Add(few, few), hn::PopulationCount(ones_.of[i]));
    return hn::Add(hn::ShiftLeft<3>(total_[i]), hn::SumsOf8(hn::Add(few, rest_.of[i])));
  }

 private:
  /// sum + a + b, bit by bit: the lower bits into `sum`, the carries returned.
  static HWY_INLINE Group<N> add(Group<N>& sum, const Group<N>& a, const Group<N>& b) {
    Group<N> carry;
    for (std::size_t i = 0; i < N; ++i) {
      const Bytes between = hn::Xor(sum.of[i], a.of[i]), after = hn::Xor(between, b.of[i]);
      carry.of[i] = carried(sum.of[i], between, after);
      sum.of[i] = after;
    }
    return carry;
  }
  template <class Source>
  HWY_INLINE Group<N> add_two(Source& source) {
    const Cut<N> a = source.next(), b = source.next();
    Group<N> carry;
    for (std::size_t i = 0; i < N; ++i) {
      const Bytes between = toggled(ones_.of[i], a.bits, a.masks.of[i]),
                  after = toggled(between, b.bits, b.masks.of[i]);
      carry.of[i] = carried(ones_.of[i], between, after);
      ones_.of[i] = after;
    }
    return carry;
  }
  template <class Source>
  HWY_INLINE Group<N> add_four(Source& source) {
    const Group<N> a = add_two(source), b = add_two(source);
    return add(twos_, a, b);
  }
  /// Bits that count 2^weight each.
  template <int weight>
  HWY_INLINE void add_to_rest(const Group<N>& bits) {
    for (std::size_t i = 0; i < N; ++i) {
      Bytes count = hn::PopulationCount(bits.of[i]);
      for (int k = 0; k < weight; ++k) count = hn::Add(count, count);
      rest_.of[i] = hn::Add(rest_.of[i], count);
    }
  }
  HWY_INLINE void spill_eights() {
    for (std::size_t i = 0; i < N; ++i) {
      total_[i] = hn::Add(total_[i], hn::SumsOf8(eights_.of[i]));
      eights_.of[i] = hn::Zero(ByteTag());
    }
    blocks_ = 0;
  }

  Group<N> ones_, twos_, fours_;  // bits not yet carried on
  Group<N> eights_, rest_;        // counts; the rest is at most 3 (4 + 2 + 1) 8, and leaves room for 7 * 8
  Words total_[N];                // of eights
  int blocks_ = 0;
};

/// The balls around N spels of one line, in the lanes from byte `at` of every brick on.
template <std::size_t N>
struct LineBalls {
  const Lines<3>::Widths* widths;
  std::size_t at;
  int skew;
  Bytes right[N], left[N];        // masks by the number of points beyond `from`
  Bytes to_right[N], to_left[N];  // as in AlignedBall, `skew` left out

  LineBalls(const BallRows<3>& ball, const std::uint16_t* bits, std::size_t byte)
      : widths(AlignedBall<3>{&ball, bits[0]}.widths()), at(byte), skew(ball.skew()) {
    // s = x - 7 lowest bits, at most 8; likewise the highest.
    alignas(32) static constexpr std::uint8_t kLow[24] = {0,  0,   0,   0,   0,   0,   0,   0,
                                                          1,  3,   7,   15,  31,  63,  127, 255,
                                                          255, 255, 255, 255, 255, 255, 255, 255};
    alignas(32) static constexpr std::uint8_t kHigh[24] = {0,   0,   0,   0,   0,   0,   0,   0,
                                                           128, 192, 224, 240, 248, 252, 254, 255,
                                                           255, 255, 255, 255, 255, 255, 255, 255};
    const ByteTag tag;
    for (std::size_t i = 0; i < N; ++i) {
      const int x = bits[i] % 8;
      right[i] = hn::LoadDup128(tag, kLow + x);
      left[i] = hn::LoadDup128(tag, kHigh + 7 - x);
      to_right[i] = hn::Set(tag, std::uint8_t(7 - x));
      to_left[i] = hn::Set(tag, std::uint8_t(x));
    }
  }
  /// Points of each line of a row beyond `from`.
  HWY_INLINE Bytes beyond(std::uint32_t row, int from) const {
    const ByteTag tag;
    return hn::SaturatedSub(hn::Load(tag, widths[row].of.data() + at), hn::Set(tag, std::uint8_t(from)));
  }
  /// Of those, points of each line of a run in one ball, on the right: to = to_right[i]; or on the left, with to_left[i].
  static HWY_INLINE Bytes lengths(Bytes beyond, Bytes to, const FullRun& run) {
    return hn::Min(hn::SaturatedSub(beyond, to), hn::Set(ByteTag(), std::uint8_t(run.length)));
  }
};

/// Mixed bricks and what of them is in the balls, brick by brick.
template <std::size_t N, bool kRight, bool kLeft>
struct Cuts {
  const LineBalls<N>& balls;
  const MixedBrick* entry;

  HWY_INLINE Cut<N> next() {
    const ByteTag tag;
    Cut<N> cut;
    cut.bits = hn::Load(tag, reinterpret_cast<const std::uint8_t*>(entry->words) + balls.at);
    // Without a skew, both sides reach alike.
    const Bytes right = kRight ? reached(0) : hn::Zero(tag);
    const Bytes left = !kLeft ? hn::Zero(tag) : kRight && balls.skew == 0 ? right : reached(balls.skew);
    for (std::size_t i = 0; i < N; ++i) {
      if constexpr (kRight) cut.masks.of[i] = hn::TableLookupBytes(balls.right[i], right);
      if constexpr (kLeft) {
        const Bytes mask = hn::TableLookupBytes(balls.left[i], left);
        cut.masks.of[i] = kRight ? hn::And(cut.masks.of[i], mask) : mask;
      }
    }
    ++entry;
    return cut;
  }
  /// Points of each line beyond `from`, at most 15: the tables have 16 masks.
  HWY_INLINE Bytes reached(int skew) const {
    return hn::Min(balls.beyond(entry->row, entry->from + skew), hn::Set(ByteTag(), std::uint8_t{15}));
  }
};

/// Of all entries; Source is Cuts or DiskCuts.
template <class Source, std::size_t N, class Balls>
HWY_INLINE void count_mixed(const std::vector<MixedBrick>& entries, const Balls& balls, BitCounter<N>& counter) {
  Source cuts{balls, entries.data()};
  std::size_t rest = entries.size();
  for (; rest >= 8; rest -= 8) counter.add_eight(cuts);
  counter.add_rest(cuts, rest);
}

template <std::size_t N>
HWY_INLINE void count_full(const std::vector<FullRun>& runs, const LineBalls<N>& balls, int skew,
                           const Bytes (&to)[N], Words (&totals)[N]) {
  for (const FullRun& run : runs) {
    const Bytes beyond = balls.beyond(run.row, run.from + skew);
    for (std::size_t i = 0; i < N; ++i)
      totals[i] = hn::Add(totals[i], hn::SumsOf8(balls.lengths(beyond, to[i], run)));
  }
}

/// For N spels of one line.
template <std::size_t N>
HWY_INLINE void count_line(const SourceLists<3, Counts<3>>& lists, const BallRows<3>& ball,
                           const std::uint16_t* bits, Counts<3>* counts) {
  Words totals[N];
  for (std::size_t i = 0; i < N; ++i) totals[i] = hn::Zero(WordTag());
  for (std::size_t at = 0; at < 64; at += hn::Lanes(ByteTag())) {
    const LineBalls<N> balls(ball, bits, at);
    BitCounter<N> counter;
    count_mixed<Cuts<N, true, false>>(lists.right.mixed, balls, counter);
    count_mixed<Cuts<N, false, true>>(lists.left.mixed, balls, counter);
    count_mixed<Cuts<N, true, true>>(lists.middle, balls, counter);
    count_full(lists.right.full, balls, 0, balls.to_right, totals);
    count_full(lists.left.full, balls, balls.skew, balls.to_left, totals);
    for (std::size_t i = 0; i < N; ++i) totals[i] = hn::Add(totals[i], counter.total(i));
  }
  for (std::size_t i = 0; i < N; ++i) counts[i] = {hn::GetLane(hn::SumOfLanes(WordTag(), totals[i]))};
}

void count_3d(const SourceLists<3, Counts<3>>& lists, const BallRows<3>& ball,
              std::span<const std::uint16_t> bits, Counts<3>* counts) {
  for (std::size_t i = 0; i < bits.size();) {
    const bool pair = i + 1 < bits.size() && bits[i] / 8 == bits[i + 1] / 8;
    if (pair)
      count_line<2>(lists, ball, &bits[i], counts + i);
    else
      count_line<1>(lists, ball, &bits[i], counts + i);
    i += pair ? 2 : 1;
  }
}

/// Lines of 64 points, a word each.
using LengthTag = hn::RebindToSigned<WordTag>;
using Lengths = hn::VFromD<LengthTag>;

/// The ball around one spel, in the lanes from word `at` of every brick on.
struct Disk {
  const Lines<2>::Widths* widths;
  std::size_t at;
  int to_right, to_left;

  HWY_INLINE Lengths width(std::uint32_t row) const {
    return hn::BitCast(LengthTag(), hn::Load(WordTag(), widths[row].of.data() + at));
  }
  /// max(a - b, 0).
  static HWY_INLINE Lengths beyond(Lengths a, Lengths b) {
    return hn::Max(hn::Sub(a, b), hn::Zero(LengthTag()));
  }
  static HWY_INLINE Lengths constant(int value) { return hn::Set(LengthTag(), std::int64_t{value}); }
  /// Points of each line of a brick that are not in the ball, or more where there are none that are.
  HWY_INLINE Words missing(std::uint32_t row, int from) const {
    return hn::BitCast(WordTag(), beyond(constant(64 + from), width(row)));
  }
};

template <bool kRight, bool kLeft>
struct DiskCuts {
  const Disk& disk;
  const MixedBrick* entry;

  HWY_INLINE Cut<1> next() {
    const WordTag tag;
    const Words all = hn::Set(tag, ~std::uint64_t{0});
    Words mask = all;
    // The processor's shifts by 64 and more leave nothing.
    if constexpr (kRight) mask = all >> disk.missing(entry->row, entry->from + disk.to_right);
    if constexpr (kLeft) mask = hn::And(mask, all << disk.missing(entry->row, entry->from + disk.to_left));
    const Words bits = hn::Load(tag, entry->words + disk.at);
    ++entry;
    return {hn::BitCast(ByteTag(), bits), {{hn::BitCast(ByteTag(), mask)}}};
  }
};

HWY_INLINE Words count_full(const std::vector<FullRun>& runs, const Disk& disk, int to) {
  Lengths total = hn::Zero(LengthTag());
  for (const FullRun& run : runs)
    total = hn::Add(total, hn::Min(Disk::beyond(disk.width(run.row), Disk::constant(run.from + to)),
                                   Disk::constant(run.length)));
  return hn::BitCast(WordTag(), total);
}

void count_2d(const SourceLists<2, Counts<2>>& lists, const BallRows<2>& ball,
              std::span<const std::uint16_t> bits, Counts<2>* counts) {
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const AlignedBall<2> aligned{&ball, bits[i]};
    Words total = hn::Zero(WordTag());
    for (std::size_t at = 0; at < 8; at += hn::Lanes(WordTag())) {
      const Disk disk{aligned.widths(), at, aligned.to_right(), aligned.to_left()};
      BitCounter<1> counter;
      count_mixed<DiskCuts<true, false>>(lists.right.mixed, disk, counter);
      count_mixed<DiskCuts<false, true>>(lists.left.mixed, disk, counter);
      count_mixed<DiskCuts<true, true>>(lists.middle, disk, counter);
      total = hn::Add(total, counter.total(0));
      total = hn::Add(total, count_full(lists.right.full, disk, disk.to_right));
      total = hn::Add(total, count_full(lists.left.full, disk, disk.to_left));
    }
    counts[i] = {hn::GetLane(hn::SumOfLanes(WordTag(), total))};
  }
}

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
