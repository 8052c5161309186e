#pragma once

#include <array>
#include <cstdint>

#include "estimators/integral_invariant/sums.hpp"

namespace gridstep::bricks {

/// The sums of an integral invariant modulo 2^64, in which prefix sums and translations may wrap around: the
/// result is exact wherever the sum itself fits 64 bits.
template <class Sum>
struct ModularOf;
template <int d>
struct ModularOf<PlainSum<d, std::int64_t>> {
  using type = PlainSum<d, std::uint64_t>;
};
template <int d>
struct ModularOf<MomentSums<d, std::int64_t>> {
  using type = MomentSums<d, std::uint64_t>;
};
template <class Sum>
using Modular = typename ModularOf<Sum>::type;

template <int d>
using Counts = PlainSum<d, std::uint64_t>;
template <int d>
using Moments = MomentSums<d, std::uint64_t>;

template <int d>
PlainSum<d, std::int64_t> to_signed(const Counts<d>& sum) {
  return {std::int64_t(sum.n)};
}
template <int d>
MomentSums<d, std::int64_t> to_signed(const MomentSums<d, std::uint64_t>& sum) {
  MomentSums<d, std::int64_t> result;
  result.n = std::int64_t(sum.n);
  for (std::size_t i = 0; i < sum.first.size(); ++i) result.first[i] = std::int64_t(sum.first[i]);
  for (std::size_t i = 0; i < sum.second.size(); ++i) result.second[i] = std::int64_t(sum.second[i]);
  return result;
}

template <class Sum>
void subtract(Sum& sum, const Sum& other) {
  sum.merge(other, ~std::uint64_t{0});
}
template <class Sum>
void add(Sum& sum, const Sum& other) {
  sum.merge(other, 1);
}

/// Sums of 1, x, x^2 over x = first, ..., first + length - 1; for lengths below 2^32.
struct Stretch {
  std::uint64_t n, x, xx;

  Stretch(std::int64_t first, std::int64_t length) : n(std::uint64_t(length)) {
    constexpr std::uint64_t kThird = 0xaaaa'aaaa'aaaa'aaab;  // times 3 it is 1: divides multiples of 3
    const auto start = std::uint64_t(first);
    const std::uint64_t triangle = n * (n - 1) / 2;  // 0 + 1 + ... + (length - 1)
    x = n * start + triangle;
    xx = n * start * start + 2 * start * triangle + triangle * (2 * n - 1) * kThird;
  }
};

// Planes and boxes are inlined by force: each spel needs two planes extruded, each side of a source brick a box.

/// The points of a plane p_axis = 0, again for every p_axis of a stretch.
template <int axis, int d>
Counts<d> extruded(const Counts<d>& plane, const Stretch& along) {
  return {plane.n * along.n};
}
template <int axis, int d>
[[gnu::always_inline]] inline Moments<d> extruded(const Moments<d>& plane, const Stretch& along) {
  Moments<d> result;
  result.n = plane.n * along.n;
  for (int i = 0, pair = 0; i < d; ++i) {
    result.first[i] = i == axis ? plane.n * along.x : plane.first[i] * along.n;
    for (int j = i; j < d; ++j, ++pair)
      result.second[pair] = i != axis && j != axis ? plane.second[pair] * along.n
                            : i != axis            ? plane.first[i] * along.x
                            : j != axis            ? plane.first[j] * along.x
                                                   : plane.n * along.xx;
  }
  return result;
}

/// Adds all points of a box.
template <class Sum, int d>
[[gnu::always_inline]] inline void add_box(Sum& sum, const LatticePoint<d>& first,
                                           const LatticePoint<d>& extent) {
  Sum box;
  box.n = 1;  // a point at the origin
  box = extruded<0>(box, Stretch(first[0], extent[0]));
  box = extruded<1>(box, Stretch(first[1], extent[1]));
  if constexpr (d == 3) box = extruded<2>(box, Stretch(first[2], extent[2]));
  add(sum, box);
}

/// The points mirrored, x -> -x.
template <int d>
void mirror_x(Counts<d>&) {}
template <int d>
void mirror_x(Moments<d>& sum) {
  sum.first[0] = -sum.first[0];
  for (int k = 1; k < d; ++k) sum.second[k] = -sum.second[k];
}

}  // namespace gridstep::bricks
