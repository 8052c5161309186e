// The number of points that a ball cuts out of M and F. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

template <class Masks>
HWY_INLINE Words count_mixed(const std::vector<MixedBrick>& entries, const Lines<3>::Widths* widths,
                             Masks masks) {
  const ByteTag tag;
  constexpr std::size_t kParts = 64 / hn::MaxLanes(tag);
  constexpr std::size_t kBatch = 255 / (8 * kParts);  // entries whose counts a byte holds
  Words total = hn::Zero(WordTag());
  for (std::size_t begin = 0; begin < entries.size(); begin += kBatch) {
    const std::size_t end = std::min(entries.size(), begin + kBatch);
    Bytes counts = hn::Zero(tag);
    for (std::size_t i = begin; i < end; ++i) {
      const MixedBrick& entry = entries[i];
      const auto* const brick = reinterpret_cast<const std::uint8_t*>(entry.words);
      const std::uint8_t* const row = widths[entry.row].of.data();
      for (std::size_t at = 0; at < 64; at += hn::Lanes(tag)) {
        const Bytes mask = masks(hn::Load(tag, row + at), entry.from);
        counts = hn::Add(counts, hn::PopulationCount(hn::And(mask, hn::Load(tag, brick + at))));
      }
    }
    total = hn::Add(total, hn::SumsOf8(counts));
  }
  return total;
}

HWY_INLINE Words count_full(const std::vector<FullRun>& runs, const Lines<3>::Widths* widths, int to) {
  const ByteTag tag;
  Words total = hn::Zero(WordTag());
  for (const FullRun& run : runs) {
    const std::uint8_t* const row = widths[run.row].of.data();
    for (std::size_t at = 0; at < 64; at += hn::Lanes(tag))
      total = hn::Add(total, hn::SumsOf8(clipped(hn::Load(tag, row + at), run.from + to, run.length)));
  }
  return total;
}

Counts<3> count_3d(const SourceLists<3, Counts<3>>& lists, const AlignedBall<3>& ball) {
  const Lines<3>::Widths* const widths = ball.widths();
  const ByteMasks masks(ball.to_right(), ball.to_left());
  Words total = count_mixed(lists.right.mixed, widths,
                            [&](Bytes row, int from) HWY_ATTR { return masks.right(row, from); });
  total = hn::Add(total, count_mixed(lists.left.mixed, widths,
                                     [&](Bytes row, int from) HWY_ATTR { return masks.left(row, from); }));
  total = hn::Add(total, count_mixed(lists.middle, widths,
                                     [&](Bytes row, int from) HWY_ATTR { return masks.middle(row, from); }));
  total = hn::Add(total, count_full(lists.right.full, widths, ball.to_right()));
  total = hn::Add(total, count_full(lists.left.full, widths, ball.to_left()));
  return {hn::GetLane(hn::SumOfLanes(WordTag(), total))};
}

/// Lines of 64 points, a word each.
using LengthTag = hn::RebindToSigned<WordTag>;
using Lengths = hn::VFromD<LengthTag>;

HWY_INLINE Lengths beyond(Words widths, int from) {
  return hn::Sub(hn::BitCast(LengthTag(), widths), hn::Set(LengthTag(), std::int64_t(from)));
}

/// The lowest `length` bits, at most 64; none where it is negative.
HWY_INLINE Words low_bits(Lengths length) {
  const WordTag tag;
  const auto one = hn::Set(tag, std::uint64_t{1});
  const auto shift = hn::BitCast(tag, hn::Sub(hn::Min(length, hn::Set(LengthTag(), std::int64_t{64})),
                                              hn::Set(LengthTag(), std::int64_t{1})));
  // 2 << 63 wraps around to 0, whose predecessor has all bits.
  const Words bits =
      hn::Sub(hn::Set(tag, std::uint64_t{2}) << hn::And(shift, hn::Set(tag, std::uint64_t{63})), one);
  return hn::IfThenElseZero(hn::RebindMask(tag, hn::Gt(length, hn::Zero(LengthTag()))), bits);
}

/// The highest ones.
HWY_INLINE Words high_bits(Lengths length) {
  return hn::Not(low_bits(hn::Sub(hn::Set(LengthTag(), std::int64_t{64}), length)));
}

template <class Masks>
HWY_INLINE Words count_mixed_2d(const std::vector<MixedBrick>& entries, const Lines<2>::Widths* widths,
                                Masks masks) {
  const WordTag tag;
  Words total = hn::Zero(tag);
  for (const MixedBrick& entry : entries)
    for (std::size_t at = 0; at < 8; at += hn::Lanes(tag)) {
      const Words mask = masks(hn::Load(tag, widths[entry.row].of.data() + at), entry.from);
      total = hn::Add(total, hn::PopulationCount(hn::And(mask, hn::Load(tag, entry.words + at))));
    }
  return total;
}

HWY_INLINE Words count_full_2d(const std::vector<FullRun>& runs, const Lines<2>::Widths* widths, int to) {
  const WordTag tag;
  Words total = hn::Zero(tag);
  for (const FullRun& run : runs)
    for (std::size_t at = 0; at < 8; at += hn::Lanes(tag)) {
      const Lengths length = beyond(hn::Load(tag, widths[run.row].of.data() + at), run.from + to);
      const Lengths most = hn::Set(LengthTag(), std::int64_t(run.length));
      total = hn::Add(total, hn::BitCast(tag, hn::Min(hn::Max(length, hn::Zero(LengthTag())), most)));
    }
  return total;
}

Counts<2> count_2d(const SourceLists<2, Counts<2>>& lists, const AlignedBall<2>& ball) {
  const Lines<2>::Widths* const widths = ball.widths();
  const int to_right = ball.to_right(), to_left = ball.to_left();
  Words total = count_mixed_2d(lists.right.mixed, widths, [&](Words row, int from) HWY_ATTR {
    return low_bits(beyond(row, from + to_right));
  });
  total = hn::Add(total, count_mixed_2d(lists.left.mixed, widths, [&](Words row, int from) HWY_ATTR {
                    return high_bits(beyond(row, from + to_left));
                  }));
  total = hn::Add(total, count_mixed_2d(lists.middle, widths, [&](Words row, int from) HWY_ATTR {
                    return hn::And(low_bits(beyond(row, from + to_right)),
                                   high_bits(beyond(row, from + to_left)));
                  }));
  total = hn::Add(total, count_full_2d(lists.right.full, widths, to_right));
  total = hn::Add(total, count_full_2d(lists.left.full, widths, to_left));
  return {hn::GetLane(hn::SumOfLanes(WordTag(), total))};
}

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
