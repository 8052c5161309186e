#pragma once

#include <cstdint>
#include <initializer_list>

namespace gridstep {

/// SplitMix64 [Steele, Lea, Flood, OOPSLA 2014, fig. 16]: small, fast, and the same on every platform, which
/// the distributions of <random> are not.
class RandomStream {
 public:
  /// The stream of a seed and any further integers that name a place in an experiment (a step, a shift, a
  /// cell).
  explicit RandomStream(std::initializer_list<std::uint64_t> key) {
    for (const std::uint64_t part : key) state_ = bits() ^ part;
  }

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1), with 53 random bits.
  double uniform() { return double(bits() >> 11) * 0x1p-53; }

  /// Uniform in 0 .. n-1; n far below 2^32, where the bias of the multiplication is negligible.
  std::uint32_t below(std::uint32_t n) { return std::uint32_t(((bits() >> 32) * n) >> 32); }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace gridstep
