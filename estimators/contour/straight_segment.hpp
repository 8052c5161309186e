#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>

#include "shapes/base/lattice.hpp"

namespace gridstep {

/// A standard (4-connected) digital straight line [Reveilles 1991]: the points with
///   mu <= a x - b y < mu + |a| + |b|.
/// (b, a) is its primitive direction; the remainder a x - b y grows to the right of it.
struct DigitalLine {
  std::int64_t a = 0, b = 0, mu = 0;

  std::int64_t thickness() const { return std::abs(a) + std::abs(b); }
  std::int64_t remainder(const LatticePoint<2>& p) const { return a * p[0] - b * p[1]; }
  bool contains(const LatticePoint<2>& p) const {
    const std::int64_t above = remainder(p) - mu;
    return 0 <= above && above < thickness();
  }
};

enum class SegmentEnd { back, front };

/// A digital straight segment, recognized pointel by pointel: consecutive pointels of a 4-connected path that
/// lie on a standard digital line. Its line is the one of least thickness.
///
/// The line is held by leaning points: those of remainder mu on its left and mu + |a| + |b| - 1 on its right,
/// the first and the last of each. Adding as in [Debled-Rennesson & Reveilles, IJPRAI 1995]; removing undoes
/// an addition, as in [Feschet & Tougne, DGCI 1999; Lachaud, Vialard & de Vieilleville, DGCI 2005].
/// Exact for |coordinates| < 2^30. Cost O(1) an operation, no allocation.
class StraightSegment {
 public:
  /// The one pointel p. Its line is null until a second one is added.
  explicit StraightSegment(const LatticePoint<2>& p) : tips_{p, p}, leaning_{{{p, p}, {p, p}}} {}

  /// Adds the pointel that follows the front, or precedes the back, by one unit step. Returns false, and
  /// changes nothing, where the result would not be a digital straight segment.
  bool add(SegmentEnd end, const LatticePoint<2>& p);
  /// @throws ContractViolation where there is only one pointel.
  void remove(SegmentEnd end);

  const LatticePoint<2>& back() const { return tips_[0]; }
  const LatticePoint<2>& front() const { return tips_[1]; }
  /// Number of pointels.
  std::int64_t size() const { return distance(back(), front()) + 1; }
  const DigitalLine& line() const { return line_; }

 private:
  /// Number of steps between two of the pointels: segments are monotone.
  static std::int64_t distance(const LatticePoint<2>& p, const LatticePoint<2>& q) {
    return std::abs(q[0] - p[0]) + std::abs(q[1] - p[1]);
  }
  void set_direction(const LatticePoint<2>& v);
  LatticePoint<2> neighbour_inside(SegmentEnd end) const;
  void fall_back(int side, int end);

  std::array<LatticePoint<2>, 2> tips_;                    // by end
  std::array<std::array<LatticePoint<2>, 2>, 2> leaning_;  // by side (left, right) and end
  DigitalLine line_;
};

}  // namespace gridstep
