// Compiled once for each instruction set, by Highway (https://github.com/google/highway).

#include "shapes/digital/brick_levels.hpp"

#define HWY_TARGET_INCLUDE "shapes/digital/brick_levels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace gridstep::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, 16>;

/// Writes the bits of a mask, of points i and on, to where bits of zero are.
HWY_INLINE void store_bits(hn::Mask<Tag> mask, std::size_t i, std::uint8_t* bits) {
  if (hn::Lanes(Tag()) >= 8) {
    hn::StoreMaskBits(Tag(), mask, bits + i / 8);
  } else {
    std::array<std::uint8_t, 8> part{};
    hn::StoreMaskBits(Tag(), mask, part.data());
    bits[i / 8] = std::uint8_t(bits[i / 8] | part[0] << (i % 8));
  }
}

/// A word holds the points of one coordinate w, the last one; bit i those with x = i % extent, y = i / extent. So the
/// level is that of w alone, and for each bit a number and w times another one.
template <int d>
ComparedLevels<d> compare_levels(const BrickLevels<d>& levels, float within) {
  constexpr int kExtent = Brick<d>::extent(0);
  const Tag tag;
  const std::size_t lanes = hn::Lanes(tag);
  alignas(64) std::array<float, 64> at_first, per_word;
  const auto linear = [&](int k) { return hn::Set(tag, levels.linear[std::size_t(k)]); };
  const auto square = [&](int pair) { return hn::Set(tag, levels.square[std::size_t(pair)]); };
  for (std::size_t i = 0; i < 64; i += lanes) {
    const auto bit = hn::Iota(tag, float(i));
    if constexpr (d == 2) {
      hn::Store(hn::Mul(bit, hn::Add(linear(0), hn::Mul(bit, square(0)))), tag, at_first.data() + i);
      hn::Store(hn::Mul(bit, square(1)), tag, per_word.data() + i);
    } else {
      const auto y = hn::Floor(hn::Mul(bit, hn::Set(tag, 1.0f / kExtent)));
      const auto x = hn::Sub(bit, hn::Mul(y, hn::Set(tag, float(kExtent))));
      const auto of_x = hn::Mul(x, hn::Add(linear(0), hn::Add(hn::Mul(x, square(0)), hn::Mul(y, square(1)))));
      const auto of_y = hn::Mul(y, hn::Add(linear(1), hn::Mul(y, square(3))));
      hn::Store(hn::Add(of_x, of_y), tag, at_first.data() + i);
      hn::Store(hn::Add(hn::Mul(x, square(2)), hn::Mul(y, square(4))), tag, per_word.data() + i);
    }
  }
  std::array<std::uint8_t, Brick<d>::kBits / 8> below{}, above{};
  for (std::size_t w = 0; w < 8; ++w) {
    const auto word = float(w);
    const float of_word = levels.constant + word * (levels.linear[d - 1] + word * levels.square.back());
    const auto low = hn::Set(tag, -within - of_word), high = hn::Set(tag, within - of_word);
    for (std::size_t i = 0; i < 64; i += lanes) {
      const auto level = hn::Add(hn::Load(tag, at_first.data() + i),
                                 hn::Mul(hn::Set(tag, word), hn::Load(tag, per_word.data() + i)));
      store_bits(hn::Lt(level, low), 64 * w + i, below.data());
      store_bits(hn::Gt(level, high), 64 * w + i, above.data());
    }
  }
  static_assert(std::endian::native == std::endian::little);
  return {std::bit_cast<Brick<d>>(below), std::bit_cast<Brick<d>>(above)};
}

ComparedLevels<2> compare_2d(const BrickLevels<2>& levels, float within) {
  return compare_levels<2>(levels, within);
}
ComparedLevels<3> compare_3d(const BrickLevels<3>& levels, float within) {
  return compare_levels<3>(levels, within);
}

}  // namespace
}  // namespace gridstep::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gridstep {

HWY_EXPORT(compare_2d);
HWY_EXPORT(compare_3d);

template <>
ComparedLevels<2> compare(const BrickLevels<2>& levels, float within) {
  return HWY_DYNAMIC_DISPATCH(compare_2d)(levels, within);
}
template <>
ComparedLevels<3> compare(const BrickLevels<3>& levels, float within) {
  return HWY_DYNAMIC_DISPATCH(compare_3d)(levels, within);
}

}  // namespace gridstep
#endif
