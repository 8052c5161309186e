#pragma once

#include <cstdint>

#include "estimators/integral_invariant/bricks/exact_sums.hpp"
#include "shapes/digital/brick.hpp"

namespace gridstep::bricks {

/// Number of points, all words at once: std::popcount is a function call a word where it may not take the instruction.
template <int d>
std::uint64_t count_bits(const Brick<d>& brick) {
  constexpr std::uint64_t kPairs = 0x5555555555555555, kNibbles = 0x3333333333333333, kBytes = 0x0f0f0f0f0f0f0f0f,
                          kShorts = 0x00ff00ff00ff00ff, kEachShort = 0x0001000100010001;
  std::uint64_t bytes = 0;  // at most 8 words of 8
  for (std::uint64_t word : brick.words) {
    word -= word >> 1 & kPairs;
    word = (word & kNibbles) + (word >> 2 & kNibbles);
    bytes += (word + (word >> 4)) & kBytes;
  }
  return ((bytes & kShorts) + (bytes >> 8 & kShorts)) * kEachShort >> 48;
}

/// Adds the points of a brick whose lowest cell is at `origin`.
template <int d>
void add_brick(Counts<d>& sum, const Brick<d>& brick, const LatticePoint<d>&) {
  sum.n += count_bits(brick);
}
void add_brick(Moments& sum, const Brick<3>& brick, const LatticePoint<3>& origin);

}  // namespace gridstep::bricks
