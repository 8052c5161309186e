#pragma once

#include <cstdint>
#include <vector>

#include "shapes/base/lattice.hpp"

namespace gridstep {

__extension__ typedef __int128 Wide;

/// A line of the dual plane: f(x, y) = A |u|^2 + B x + C y with u = (x, y) relative to a pole, or A + B x + C y.
struct Pencil {
  Wide B = 0, C = 0, A = 0;
};

/// Separation of inner from outer points by curves of a pencil: all circles and lines through one point, the
/// pole, or all lines. Inversion at the pole makes the first a set of lines too: a point u relative to the pole
/// becomes u / |u|^2, here with the homogeneous coordinates (x, y, |u|^2), and lines keep (x, y, 1). A curve of
/// the pencil separates where f <= 0 at inner and f >= 0 at outer points, f nonzero.
///
/// Keeps the curve of extreme direction among those that separate, one of the two inner common tangents of the
/// convex hulls; a point that this curve does not separate lies on the next one [Seidel, Small-dimensional linear
/// programming and convex hulls made easy, DCG 6, 1991]. Exact for points at most 2^28 apart.
class PencilSeparation {
 public:
  /// Which of the two tangents is kept: on the left of the way from its inner to its outer contact in the
  /// inverted plane it has the inner, or the outer points.
  enum class Tangent { inner_on_left, outer_on_left };

  /// The pencil of lines, or that of circles through the pole; no points yet.
  void reset_lines(const LatticePoint<2>& origin, Tangent tangent);
  void reset_circles(const LatticePoint<2>& pole, Tangent tangent);

  /// Adds a point and its constraint. False if no curve of the pencil separates any more: the object is then of
  /// no use until the next reset. The pole itself is no constraint. Cost O(1) where the curve separates the
  /// point, else linear in the number of points.
  bool add_inner(const LatticePoint<2>& point);
  bool add_outer(const LatticePoint<2>& point);

  /// The curve kept. Valid with an inner and an outer point, both other than the pole.
  const Pencil& curve() const { return curve_; }

 private:
  struct Point {
    std::int64_t x, y, w;
    bool is_pole() const { return w == 0; }
  };

  Point homogeneous(const LatticePoint<2>& point);
  static Pencil join(const Point& p, const Point& q, int sign);
  /// f(p). Near the pole, |x| and |y| <= 2^14, w < 2^30 and the coefficients are below 2^46: 64 bits hold it.
  Wide at(const Pencil& f, const Point& p) const {
    if (narrow_) return std::int64_t(f.B) * p.x + std::int64_t(f.C) * p.y + std::int64_t(f.A) * p.w;
    return f.B * p.x + f.C * p.y + f.A * p.w;
  }
  bool has_curve() const { return !inner_.empty() && !outer_.empty(); }
  bool separates();
  /// Finds another curve where the one kept does not separate the new point.
  template <class Lean>
  bool turn(Lean lean);
  /// Sets the curve through the new point that is extreme among those with the points of the other side on their
  /// side, and tells whether it separates.
  bool lean_on_inner(const Point& p, int sign);
  bool lean_on_outer(const Point& q, int sign);

  static constexpr std::int64_t kNarrow = 1 << 14;

  LatticePoint<2> origin_ = LatticePoint<2>::Zero();
  bool circles_ = false;
  bool narrow_ = true;      // whether all points are near the pole
  bool undecided_ = false;  // whether all points are on the curve: either side may be the inner one
  int sign_ = 1;
  std::vector<Point> inner_, outer_;
  Pencil curve_;
};

}  // namespace gridstep
