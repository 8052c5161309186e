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
using Moments = MomentSums<3, std::uint64_t>;

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

/// Sums of 1, x, x^2 over x = first, ..., first + length - 1; exact modulo 2^64 for lengths below 10^6.
struct Stretch {
  std::uint64_t n, x, xx;

  Stretch(std::int64_t first, std::int64_t length)
      : n(std::uint64_t(length)),
        x(n * std::uint64_t(first) + n * (n - 1) / 2),
        xx(n * std::uint64_t(first) * std::uint64_t(first) + std::uint64_t(first) * (n * (n - 1)) +
           (n > 0 ? (n - 1) * n * (2 * n - 1) / 6 : 0)) {}
};

/// Adds the `length` points from `first` on along x.
template <int d>
void add_stretch(Counts<d>& sum, const LatticePoint<d>&, std::int64_t length) {
  sum.n += std::uint64_t(length);
}
inline void add_stretch(Moments& sum, const LatticePoint<3>& first, std::int64_t length) {
  const Stretch s(first[0], length);
  const auto y = std::uint64_t(first[1]), z = std::uint64_t(first[2]);
  add(sum, {s.n, {s.x, y * s.n, z * s.n}, {s.xx, y * s.x, z * s.x, y * y * s.n, y * z * s.n, z * z * s.n}});
}

/// The points of a plane x = 0, again for every x of a stretch.
template <int d>
Counts<d> extruded(const Counts<d>& plane, const Stretch& x) {
  return {plane.n * x.n};
}
inline Moments extruded(const Moments& plane, const Stretch& x) {
  const auto& [n, first, second] = plane;
  return {n * x.n,
          {n * x.x, first[1] * x.n, first[2] * x.n},
          {n * x.xx, first[1] * x.x, first[2] * x.x, second[3] * x.n, second[4] * x.n, second[5] * x.n}};
}

/// Adds all points of a box.
template <int d>
void add_box(Counts<d>& sum, const LatticePoint<d>&, const LatticePoint<d>& extent) {
  std::uint64_t volume = 1;
  for (int k = 0; k < d; ++k) volume *= std::uint64_t(extent[k]);
  sum.n += volume;
}
inline void add_box(Moments& sum, const LatticePoint<3>& first, const LatticePoint<3>& extent) {
  const Stretch x(first[0], extent[0]), y(first[1], extent[1]), z(first[2], extent[2]);
  add(sum, {x.n * y.n * z.n,
            {x.x * y.n * z.n, x.n * y.x * z.n, x.n * y.n * z.x},
            {x.xx * y.n * z.n, x.x * y.x * z.n, x.x * y.n * z.x, x.n * y.xx * z.n, x.n * y.x * z.x,
             x.n * y.n * z.xx}});
}

/// The points mirrored, x -> -x.
template <int d>
void mirror_x(Counts<d>&) {}
inline void mirror_x(Moments& sum) {
  sum.first[0] = -sum.first[0];
  sum.second[1] = -sum.second[1];
  sum.second[2] = -sum.second[2];
}

}  // namespace gridstep::bricks
