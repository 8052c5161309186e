#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "shapes/base/lattice.hpp"

namespace gridstep {

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
  /// Distance in bits between neighbours along an axis.
  static constexpr int stride(int axis) {
    int result = 1;
    for (int k = 0; k < axis; ++k) result <<= kShift[k];
    return result;
  }

  std::array<std::uint64_t, 8> words{};

  static Brick full() {
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
    for (int k = 0; k < d; ++k) index += (z[k] & (extent(k) - 1)) * stride(k);
    return index;
  }
  /// The digital point of a bit, relative to the origin.
  static LatticePoint<d> offset(int bit) {
    LatticePoint<d> z;
    for (int k = 0; k < d; ++k) z[k] = (bit / stride(k)) & (extent(k) - 1);
    return z;
  }

  bool test(int bit) const { return (words[std::size_t(bit) >> 6] >> (bit & 63)) & 1; }
  void set(int bit, bool value) {
    const std::uint64_t mask = std::uint64_t{1} << (bit & 63);
    std::uint64_t& word = words[std::size_t(bit) >> 6];
    word = value ? word | mask : word & ~mask;
  }
  int count() const {
    int result = 0;
    for (const std::uint64_t word : words) result += std::popcount(word);
    return result;
  }
  friend bool operator==(const Brick&, const Brick&) = default;
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
  const int stride = Brick<d>::stride(axis), group = stride * Brick<d>::extent(axis);
  Brick<d> result;
  if (stride >= 64) {
    const int step = stride / 64, wrap = group / 64;
    for (int i = 0; i < 8; ++i) {
      const int in_group = i % wrap + direction * step;
      const int source = i - i % wrap + (in_group + wrap) % wrap;
      result.words[i] = (in_group < 0 || in_group >= wrap ? next : brick).words[source];
    }
    return result;
  }
  // `low` marks, in every group of bits, those that receive a bit of the same brick when shifting down.
  std::uint64_t low = 0;
  for (int g = 0; g < 64; g += group)
    low |= ((group - stride == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << (group - stride)) - 1)) << g;
  for (int i = 0; i < 8; ++i) {
    const std::uint64_t own = brick.words[i], far = next.words[i];
    result.words[i] = direction > 0 ? ((own >> stride) & low) | ((far << (group - stride)) & ~low)
                                    : ((own & low) << stride) | ((far & ~low) >> (group - stride));
  }
  return result;
}

}  // namespace gridstep
