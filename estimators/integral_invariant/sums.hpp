#pragma once

#include <array>
#include <cstdint>

#include "shapes/base/lattice.hpp"

namespace gridstep {

/// What a convolution adds up at an evaluation point: the plain sum  n = sum f(s + p) g(p).
template <int d, class Value>
struct PlainSum {
  Value n{};

  void add(const Value& value, const LatticePoint<d>&) { n += value; }
  void merge(const PlainSum& group, const Value& weight) { n += weight * group.n; }
  /// Offsets are taken from the evaluation point; it moves by `step`, and the offsets by -step.
  void move(const LatticePoint<d>&) {}
  friend bool operator==(const PlainSum&, const PlainSum&) = default;
};

/// The same with first and second moments of the offsets: n, sum p_i, sum p_i p_j (i <= j: xx, xy, xz, yy,
/// yz, zz).
template <int d, class Value>
struct MomentSums {
  static constexpr int kPairs = d * (d + 1) / 2;
  Value n{};
  std::array<Value, d> first{};
  std::array<Value, kPairs> second{};

  void add(const Value& value, const LatticePoint<d>& p) {
    n += value;
    for (int i = 0, pair = 0; i < d; ++i) {
      const Value moment = value * Value(p[i]);
      first[i] += moment;
      for (int j = i; j < d; ++j) second[pair++] += moment * Value(p[j]);
    }
  }
  void merge(const MomentSums& group, const Value& weight) {
    n += weight * group.n;
    for (int i = 0; i < d; ++i) first[i] += weight * group.first[i];
    for (int i = 0; i < kPairs; ++i) second[i] += weight * group.second[i];
  }
  /// (p - e)(p - e)' = pp' - pe' - ep' + ee'.
  void move(const LatticePoint<d>& step) {
    for (int i = 0, pair = 0; i < d; ++i)
      for (int j = i; j < d; ++j)
        second[pair++] +=
            n * Value(step[i]) * Value(step[j]) - first[i] * Value(step[j]) - first[j] * Value(step[i]);
    for (int i = 0; i < d; ++i) first[i] -= n * Value(step[i]);
  }
  friend bool operator==(const MomentSums&, const MomentSums&) = default;
};

}  // namespace gridstep
