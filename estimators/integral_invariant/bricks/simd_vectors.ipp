// What the vector loops share. Included once for each instruction set.

HWY_BEFORE_NAMESPACE();
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A brick, or the half-widths of a row, is one vector of 64 bytes or several smaller ones.
using ByteTag = hn::CappedTag<std::uint8_t, 64>;
using WordTag = hn::Repartition<std::uint64_t, ByteTag>;
using Bytes = hn::VFromD<ByteTag>;
using Words = hn::VFromD<WordTag>;
using IntTag = hn::Repartition<std::int32_t, ByteTag>;
using Ints = hn::VFromD<IntTag>;
using LongTag = hn::Repartition<std::int64_t, ByteTag>;
using Longs = hn::VFromD<LongTag>;

/// max(a - b, 0).
HWY_INLINE Bytes beyond(Bytes a, Bytes b) {
  return hn::SaturatedSub(a, b);
}
HWY_INLINE Longs beyond(Longs a, Longs b) {
  return hn::Max(hn::Sub(a, b), hn::Zero(LongTag()));
}

/// Of numbers that fit 32 bits.
HWY_INLINE Longs times(Longs a, Longs b) {
  return hn::MulEven(hn::BitCast(IntTag(), a), hn::BitCast(IntTag(), b));
}

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
