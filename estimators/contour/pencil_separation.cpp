#include "estimators/contour/pencil_separation.hpp"

#include <cstdlib>

namespace gridstep {

void PencilSeparation::reset_lines(const LatticePoint<2>& origin, Tangent tangent) {
  reset_circles(origin, tangent);
  circles_ = false;
}

void PencilSeparation::reset_circles(const LatticePoint<2>& pole, Tangent tangent) {
  origin_ = pole;
  circles_ = true;
  narrow_ = true;
  undecided_ = false;
  sign_ = tangent == Tangent::inner_on_left ? -1 : 1;
  inner_.clear();
  outer_.clear();
}

PencilSeparation::Point PencilSeparation::homogeneous(const LatticePoint<2>& point) {
  const std::int64_t x = std::int64_t(point[0]) - origin_[0], y = std::int64_t(point[1]) - origin_[1];
  narrow_ = narrow_ && std::abs(x) <= kNarrow && std::abs(y) <= kNarrow;
  return {x, y, circles_ ? x * x + y * y : 1};
}

Pencil PencilSeparation::join(const Point& p, const Point& q, int sign) {
  const auto minor = [sign](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return sign * (Wide(a) * d - Wide(b) * c);
  };
  return {minor(p.y, p.w, q.y, q.w), minor(p.w, p.x, q.w, q.x), minor(p.x, p.y, q.x, q.y)};
}

bool PencilSeparation::separates() {
  bool all_on_it = true;
  for (const Point& p : inner_) {
    const Wide f = at(curve_, p);
    if (f > 0) return false;
    all_on_it = all_on_it && f == 0;
  }
  for (const Point& q : outer_) {
    const Wide f = at(curve_, q);
    if (f < 0) return false;
    all_on_it = all_on_it && f == 0;
  }
  undecided_ = all_on_it;
  return true;
}

bool PencilSeparation::lean_on_inner(const Point& p, int sign) {
  curve_ = join(p, outer_.front(), sign);
  for (const Point& q : outer_)
    if (at(curve_, q) < 0) curve_ = join(p, q, sign);
  return separates();
}

bool PencilSeparation::lean_on_outer(const Point& q, int sign) {
  curve_ = join(inner_.front(), q, sign);
  for (const Point& p : inner_)
    if (at(curve_, p) > 0) curve_ = join(p, q, sign);
  return separates();
}

// Where only one curve is left, both tangents are this one, and it may be the other one's contacts that the new point
// is among: then it is found with the other sign. And where all points before were on the curve, the new point may
// be where both sides of it are to be exchanged.
template <class Lean>
bool PencilSeparation::turn(Lean lean) {
  const Pencil before = curve_;
  const bool exchangeable = undecided_;
  if (lean(sign_) || lean(-sign_)) return true;
  curve_ = {-before.B, -before.C, -before.A};
  return exchangeable && separates();
}

bool PencilSeparation::add_inner(const LatticePoint<2>& point) {
  const Point p = homogeneous(point);
  if (p.is_pole()) return true;
  const bool had_curve = has_curve();
  const Wide f = had_curve ? at(curve_, p) : 0;
  inner_.push_back(p);
  if (had_curve && f <= 0) {
    undecided_ = undecided_ && f == 0;
    return true;
  }
  return outer_.empty() || turn([&](int sign) { return lean_on_inner(p, sign); });
}

bool PencilSeparation::add_outer(const LatticePoint<2>& point) {
  const Point q = homogeneous(point);
  if (q.is_pole()) return true;
  const bool had_curve = has_curve();
  const Wide f = had_curve ? at(curve_, q) : 0;
  outer_.push_back(q);
  if (had_curve && f >= 0) {
    undecided_ = undecided_ && f == 0;
    return true;
  }
  return inner_.empty() || turn([&](int sign) { return lean_on_outer(q, sign); });
}

}  // namespace gridstep
