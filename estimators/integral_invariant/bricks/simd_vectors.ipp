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

/// min(max(widths - from, 0), most), byte by byte.
HWY_INLINE Bytes clipped(Bytes widths, int from, int most) {
  const ByteTag tag;
  return hn::Min(hn::SaturatedSub(widths, hn::Set(tag, std::uint8_t(from))),
                 hn::Set(tag, std::uint8_t(most)));
}

/// The part of a row's lines that a ball reaches in a mixed brick, as a mask: see AlignedBall.
class ByteMasks {
 public:
  ByteMasks(int to_right, int to_left) : to_right_(to_right), to_left_(to_left) {
    alignas(16) static constexpr std::uint8_t kLow[16] = {0, 1, 3, 7, 15, 31, 63, 127, 255};
    alignas(16) static constexpr std::uint8_t kHigh[16] = {0, 128, 192, 224, 240, 248, 252, 254, 255};
    low_ = hn::LoadDup128(ByteTag(), kLow);
    high_ = hn::LoadDup128(ByteTag(), kHigh);
  }
  HWY_INLINE Bytes right(Bytes widths, int from) const {
    return hn::TableLookupBytes(low_, clipped(widths, from + to_right_, 8));
  }
  HWY_INLINE Bytes left(Bytes widths, int from) const {
    return hn::TableLookupBytes(high_, clipped(widths, from + to_left_, 8));
  }
  HWY_INLINE Bytes middle(Bytes widths, int from) const {
    return hn::And(right(widths, from), left(widths, from));
  }

 private:
  int to_right_, to_left_;
  Bytes low_, high_;  // for s = 0 to 8: the s lowest, the s highest bits of a byte
};

}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
