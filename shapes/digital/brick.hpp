#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "shapes/base/lattice.hpp"

namespace gridstep {

// Of GCC and Clang, on every processor: one operation on two words. GCC 12 finds no such form by itself.
using TwoWords [[gnu::vector_size(16)]] = std::uint64_t;

/// Number of set bits, as sums of ever longer groups of them. std::popcount() is a call where the processor may lack its
/// instruction.
inline int count_bits(std::uint64_t word) {
  word -= (word >> 1) & 0x5555555555555555u;
  word = (word & 0x3333333333333333u) + ((word >> 2) & 0x3333333333333333u);
  return int(((word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fu) * 0x0101010101010101u >> 56);
}

/// A block of 512 digital points as bits: 8 x 8 x 8 in 3D (one byte a row of x), 64 x 8 in 2D (one word a
/// row). Bit index x + extent_x (y + extent_y z). A brick fills a cache line.
template <int d>
struct alignas(64) Brick {
  static constexpr int kBits = 512;
  /// log2 of the extent in each direction.
  static constexpr std::array<int, d> kShift = [] {
    if constexpr (d == 2) {
      return std::array{6, 3};
    } else {
      return std::array{3, 3, 3};
    }
  }();
  static constexpr int extent(int axis) { return 1 << kShift[axis]; }
  /// Distance in bits between neighbours along an axis. Along the last one it is a word.
  static constexpr int stride(int axis) { return 1 << stride_shift(axis); }
  static constexpr int stride_shift(int axis) { return axis == d - 1 ? 6 : axis * kShift[0]; }

  std::array<std::uint64_t, 8> words{};

  static constexpr Brick full() {
    Brick brick;
    brick.words.fill(~std::uint64_t{0});
    return brick;
  }

  /// The brick that holds a digital point.
  static LatticePoint<d> of(const LatticePoint<d>& z) {
    LatticePoint<d> b;
    for (int k = 0; k < d; ++k) b[k] = z[k] >> kShift[k];
    return b;
  }
  /// The lowest digital point of a brick.
  static LatticePoint<d> origin(const LatticePoint<d>& b) {
    LatticePoint<d> z;
    for (int k = 0; k < d; ++k) z[k] = b[k] * extent(k);
    return z;
  }
  static int bit(const LatticePoint<d>& z) {
    int index = 0;
    for (int k = 0; k < d; ++k) index += (z[k] & (extent(k) - 1)) << stride_shift(k);
    return index;
  }
  /// The digital point of a bit, relative to the origin.
  static LatticePoint<d> offset(int bit) {
    LatticePoint<d> z;
    for (int k = 0; k < d; ++k) z[k] = (bit >> stride_shift(k)) & (extent(k) - 1);
    return z;
  }

  bool test(int bit) const { return (words[std::size_t(bit) >> 6] >> (bit & 63)) & 1; }
  void set(int bit, bool value) {
    const std::uint64_t mask = std::uint64_t{1} << (bit & 63);
    std::uint64_t& word = words[std::size_t(bit) >> 6];
    word = value ? word | mask : word & ~mask;
  }
  /// Number of set bits: as count_bits(), all words at once.
  int count() const {
    TwoWords bytes{};
    for (TwoWords sums : std::bit_cast<std::array<TwoWords, 4>>(words)) {
      sums -= (sums >> 1) & 0x5555555555555555u;
      sums = (sums & 0x3333333333333333u) + ((sums >> 2) & 0x3333333333333333u);
      bytes += (sums + (sums >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    }
    const TwoWords pairs = (bytes & 0x00ff00ff00ff00ffu) + ((bytes >> 8) & 0x00ff00ff00ff00ffu);
    return int((pairs[0] + pairs[1]) * 0x0001000100010001u >> 48);
  }
  friend bool operator==(const Brick& a, const Brick& b) {
    std::uint64_t different = 0;
    for (std::size_t i = 0; i < a.words.size(); ++i) different |= a.words[i] ^ b.words[i];
    return different == 0;
  }
};

/// Calls visit(bit) for every set bit, in increasing order.
template <int d, class Visit>
void for_each_bit(const Brick<d>& brick, Visit visit) {
  for (int i = 0; i < 8; ++i)
    for (std::uint64_t word = brick.words[i]; word != 0; word &= word - 1)
      visit(64 * i + std::countr_zero(word));
}

/// Bit z of the result is bit z + direction e_axis of the set, `next` being the brick on that side: a shift
/// of the whole brick by words, or within the groups of bits that an axis runs through.
template <int d>
Brick<d> shifted(const Brick<d>& brick, const Brick<d>& next, int axis, int direction) {
  Brick<d> result;
  if (axis == d - 1) {  // a word for each coordinate
    const std::size_t up = direction > 0;
    for (std::size_t i = 0; i < 7; ++i) result.words[i + 1 - up] = brick.words[i + up];
    result.words[7 * up] = next.words[7 - 7 * up];
    return result;
  }
  // In every group of bits, those that receive a bit of the same brick when shifting down.
  static constexpr std::array<std::uint64_t, d> kLow = [] {
    std::array<std::uint64_t, d> low{};
    for (int k = 0; k < d - 1; ++k)
      for (int bit = 0; bit < 64; ++bit)
        if (((bit / Brick<d>::stride(k) + 1) & (Brick<d>::extent(k) - 1)) != 0)
          low[k] |= std::uint64_t{1} << bit;
    return low;
  }();
  const std::uint64_t low = kLow[std::size_t(axis)];
  const int stride = Brick<d>::stride(axis), across = stride * (Brick<d>::extent(axis) - 1);
  const auto own = std::bit_cast<std::array<TwoWords, 4>>(brick.words);
  const auto far = std::bit_cast<std::array<TwoWords, 4>>(next.words);
  std::array<TwoWords, 4> words;
  for (std::size_t i = 0; i < 4; ++i)
    words[i] = direction > 0 ? ((own[i] >> stride) & low) | ((far[i] << across) & ~low)
                             : ((own[i] & low) << stride) | ((far[i] & ~low) >> across);
  result.words = std::bit_cast<std::array<std::uint64_t, 8>>(words);
  return result;
}

}  // namespace gridstep
