#include "shapes/analytic/implicit_shape.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shapes/analytic/simd_formula.hpp"

namespace gridstep {

namespace {

/// Where f takes values of this range.
Side side_of(const Interval& f) {
  if (f.lower() > 0) return Side::outside;
  return f.upper() <= 0 ? Side::inside : Side::crossing;
}

}  // namespace

template <int d>
ImplicitShape<d>::ImplicitShape(const RealPoint<d>& centre, Formula formula, const RealBox<d>& box, bool cut,
                                LeftOut<d> left_out)
    : Shape<d>(centre),
      formula_(std::move(formula)),
      box_(box),
      cut_(cut),
      left_out_(std::move(left_out)),
      size_(box.diagonal().norm() / 2) {
  expects(formula_.variables() <= d, "a formula in the variables of the space");
  const RealPoint<d> far = 2 * box_.min().cwiseAbs().cwiseMax(box_.max().cwiseAbs());
  rounding_ = 1e-13 * formula_.magnitude({far.data(), d});
  const RealPoint<d> margin = box_.sizes() / 8;
  neighbourhood_ = {box_.min() - margin, box_.max() + margin};
  greatest_hessian_ = hessian_bound(neighbourhood_);
}

template <int d>
double ImplicitShape<d>::value(const RealPoint<d>& p) const {
  return formula_(std::span<const double>(p.data(), d));
}

template <int d>
template <class Jet>
Jet ImplicitShape<d>::jet(const RealPoint<d>& p) const {
  std::array<Jet, d> variables;
  for (int k = 0; k < d; ++k) variables[k] = Jet::variable(p[k], k);
  return formula_(std::span<const Jet>(variables));
}

template <int d>
std::uint64_t ImplicitShape<d>::local_inside(std::span<const RealPoint<d>> points) const {
  std::uint64_t result = at_most_zero(formula_, points);
  if (cut_)
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!box_.contains(points[i])) result &= ~(std::uint64_t{1} << i);
  return result;
}

template <int d>
QuadraticBound<d> ImplicitShape<d>::local_bound(const RealBox<d>& box) const {
  QuadraticBound<d> bound;
  local_bound_each({&box, 1}, {&bound, 1});
  return bound;
}

template <int d>
void ImplicitShape<d>::local_bound_each(std::span<const RealBox<d>> boxes,
                                        std::span<QuadraticBound<d>> bounds) const {
  std::array<TaylorModel<d>, Region<d>::kMostBoxes> models;
  models_over(formula_, boxes, std::span(models).first(boxes.size()));
  for (std::size_t i = 0; i < boxes.size(); ++i) bounds[i] = bound_by(models[i], boxes[i]);
}

template <int d>
QuadraticBound<d> ImplicitShape<d>::bound_by(const TaylorModel<d>& model, const RealBox<d>& box) const {
  QuadraticBound<d> bound = bound_of(model, box);
  // Over large boxes the range of a sum of squares may decide what its Taylor expansion cannot; so, too, where the model
  // is not a number.
  constexpr double kVague = 0.1;
  if (!(model.error <= kVague * model.sloping())) {
    const Side side = side_of(natural_range(box));
    if (side != Side::crossing) bound = QuadraticBound<d>::constant(side);
  }
  if (!cut_ || box_.contains(box)) return bound;
  BoundOfIntersection<d> intersection(box);
  intersection.add(bound);
  for (int k = 0; k < d; ++k) {
    intersection.add_half_space(RealPoint<d>::Unit(k), box_.max()[k]);
    intersection.add_half_space(-RealPoint<d>::Unit(k), -box_.min()[k]);
  }
  return intersection.bound();
}

/// Holds every value that is computed in the box, without slack: doubles and intervals are rounded alike.
template <int d>
Interval ImplicitShape<d>::natural_range(const RealBox<d>& box) const {
  std::array<Interval, d> variables;
  for (int k = 0; k < d; ++k) variables[k] = Interval(box.min()[k], box.max()[k]);
  return formula_(std::span<const Interval>(variables));
}

/// The side of {f <= 0}, whatever the cut.
template <int d>
Side ImplicitShape<d>::side_of_polynomial(const RealBox<d>& box) const {
  const Side first = side_of(natural_range(box));
  const RealPoint<d> far = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  if (first != Side::crossing ||
      (far.array() > 2 * box_.max().cwiseAbs().cwiseMax(box_.min().cwiseAbs()).array()).any())
    return first;

  // The centred form f(c) + grad f(box) (x - c) is tight to second order, but bounds the exact f.
  std::array<Jet1<Interval, d>, d> jets;
  for (int k = 0; k < d; ++k) jets[k] = Jet1<Interval, d>::variable(Interval(box.min()[k], box.max()[k]), k);
  const Jet1<Interval, d> slopes = formula_(std::span<const Jet1<Interval, d>>(jets));
  const RealPoint<d> middle = box.center();
  double lower = value(middle) - rounding_, upper = value(middle) + rounding_;
  for (int k = 0; k < d; ++k) {
    const double reach = std::max(box.max()[k] - middle[k], middle[k] - box.min()[k]);
    const double steepest =
        std::max(std::abs(slopes.gradient[k].lower()), std::abs(slopes.gradient[k].upper()));
    lower -= reach * steepest * (1 + 1e-12);
    upper += reach * steepest * (1 + 1e-12);
  }
  return side_of({lower, upper});
}

/// |grad f| / |Hessian f| estimates the distance to the point where the gradient vanishes.
template <int d>
bool ImplicitShape<d>::is_singular(const Jet2<d>& f) const {
  constexpr double kSingular = 1e-5;
  return f.gradient.norm() <= kSingular * size_ * f.hessian.norm();
}

/// Relative residuals up to which a foot is a foot, and up to which it is one that its polynomial leaves
/// unresolved.
constexpr double kResolved = 5e-13, kResolvedAtAll = 1e-9;

template <int d>
bool ImplicitShape<d>::is_left_out(const RealPoint<d>& p) const {
  return std::any_of(left_out_.points.begin(), left_out_.points.end(),
                     [&](const RealPoint<d>& point) { return (p - point).norm() < left_out_.distance; });
}

/// Newton's method on q + t grad f(q) = query, f(q) = 0.
template <int d>
auto ImplicitShape<d>::newton(const RealPoint<d>& query, const RealPoint<d>& start, double within) const
    -> std::optional<Foot> {
  using System = Eigen::Matrix<double, d + 1, d + 1>;
  using Vector = Eigen::Matrix<double, d + 1, 1>;
  RealPoint<d> q = start;
  if (start == query) {
    // One step along the gradient lands near the boundary, where the system is well conditioned.
    const auto f = jet<Jet1<double, d>>(q);
    const Eigen::Map<const RealPoint<d>> gradient(f.gradient.data());
    const double squared = gradient.squaredNorm();
    if (!(squared > 0)) return std::nullopt;
    RealPoint<d> step = (f.value / squared) * gradient;
    if (step.norm() > within) step *= within / step.norm();
    q -= step;
  }
  Jet2<d> f = jet(q);
  double t = (query - q).dot(f.gradient) / f.gradient.squaredNorm();
  double last = std::numeric_limits<double>::infinity();
  std::optional<Foot> best;  // with the smallest residual, `last`
  int stalled = 0;
  for (int iteration = 0; iteration < 60 && stalled < 4; ++iteration) {
    const double slope = f.gradient.norm();
    if (!(slope > 0)) return std::nullopt;
    Vector residual;
    residual.template head<d>() = q + t * f.gradient - query;
    residual[d] = f.value;
    const double size = residual.template head<d>().norm() + std::abs(f.value) / slope;
    stalled = size < last / 2 ? 0 : stalled + 1;
    if (size < last) {
      best = Foot{q, f, false};
      last = size;
    }
    if (size <= 1e-14 * size_) break;
    System system;
    system.template topLeftCorner<d, d>() = Eigen::Matrix<double, d, d>::Identity() + t * f.hessian;
    system.template topRightCorner<d, 1>() = f.gradient;
    system.template bottomLeftCorner<1, d>() = f.gradient.transpose();
    system(d, d) = 0;
    Vector step = system.inverse() * residual;  // what it loses to rounding, the next step finds
    const double length = step.template head<d>().norm();
    if (!std::isfinite(length)) break;
    if (length > within) step *= within / length;
    q -= step.template head<d>();
    t -= step[d];
    if ((q - query).norm() > 3 * within) break;
    f = jet(q);
  }
  // Rounding of f over a vanishing gradient: the boundary is known to less than the bound on residuals.
  if (best) best->singular = last > kResolved * size_;
  return last <= kResolvedAtAll * size_ ? best : std::nullopt;
}

/// Onto the boundary, along gradients.
template <int d>
std::optional<RealPoint<d>> ImplicitShape<d>::correct(RealPoint<d> p, double within) const {
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Jet2<d> f = jet(p);
    const double squared = f.gradient.squaredNorm();
    if (is_singular(f)) return p;
    RealPoint<d> step = (f.value / squared) * f.gradient;
    if (step.norm() <= 1e-13 * size_) return p;
    if (step.norm() > within / 4) step *= within / 4 / step.norm();
    p -= step;
  }
  return std::nullopt;
}

/// Slides along the boundary towards the query, which also ends well where Newton's method does not: at a
/// singular point.
template <int d>
auto ImplicitShape<d>::descend(const RealPoint<d>& query, const RealPoint<d>& start, double within) const
    -> std::optional<Foot> {
  auto q = correct(start, within);
  if (!q) return std::nullopt;
  double rate = 1;
  for (int iteration = 0; iteration < 300; ++iteration) {
    const Jet2<d> f = jet(*q);
    if (is_singular(f)) return Foot{*q, f, true};
    const RealPoint<d> normal = f.gradient.normalized(), difference = query - *q;
    const RealPoint<d> tangential = difference - difference.dot(normal) * normal;
    if (rate * tangential.norm() <= 1e-9 * size_) break;
    const auto next = correct(*q + rate * tangential, within);
    if (next && (*next - query).norm() < difference.norm()) {
      q = next;
      rate = std::min(1.0, 2 * rate);
    } else {
      rate /= 4;
    }
  }
  if (const auto foot = newton(query, *q, within)) return foot;
  const Jet2<d> f = jet(*q);
  constexpr double kNearSingular = 1e-3;  // where the slide stalls in front of a cusp
  if (f.gradient.norm() <= kNearSingular * size_ * f.hessian.norm()) return Foot{*q, f, true};
  return std::nullopt;
}

/// Boundary points on the axes and diagonals through the query, to start from: at most twice `within` away,
/// since the closest one may lie between the rays.
template <int d>
std::vector<RealPoint<d>> ImplicitShape<d>::crossings(const RealPoint<d>& query, double within) const {
  std::vector<RealPoint<d>> found;
  const bool inside = value(query) <= 0;
  for_each_point(LatticeBox<d>{LatticePoint<d>::Constant(-1), LatticePoint<d>::Constant(1)},
                 [&](const LatticePoint<d>& direction) {
                   if (direction.isZero()) return;
                   const RealPoint<d> ray = direction.template cast<double>().normalized() * (2 * within);
                   constexpr int kSteps = 16;
                   for (int i = 1; i <= kSteps; ++i) {
                     double near = double(i - 1) / kSteps, far = double(i) / kSteps;
                     if ((value(query + far * ray) <= 0) == inside) continue;
                     for (int halving = 0; halving < 30; ++halving) {
                       const double middle = (near + far) / 2;
                       ((value(query + middle * ray) <= 0) == inside ? near : far) = middle;
                     }
                     found.push_back(query + far * ray);
                     return;
                   }
                 });
  return found;
}

/// A proof that no boundary point is nearer. Let r be the distance of the foot p, n the direction from the
/// query to it (inside; outside, change signs), and L a bound on the norm of the Hessian over the ball. In
/// the open ball |x - p|^2 < -2 r n.(x - p), so that
///   f(x) <= |grad f(p)| n.(x - p) + L/2 |x - p|^2 <= (|grad f(p)| - L r) n.(x - p) < 0  where L r < |grad
///   f(p)|.
template <int d>
bool ImplicitShape<d>::proves_closest(const RealPoint<d>& query, const Foot& foot) const {
  const double distance = (query - foot.position).norm();
  if (distance <= 1e-9 * size_) return true;
  const RealPoint<d> reach = RealPoint<d>::Constant(distance);
  const RealBox<d> around(query - reach, query + reach);
  const double slope = foot.f.gradient.norm() / (distance * (1 + 1e-9));
  // The bound over the whole shape does at fine steps, and costs nothing.
  return (neighbourhood_.contains(around) && greatest_hessian_ < slope) || hessian_bound(around) < slope;
}

/// An upper bound on the Frobenius norm of the Hessian over a box.
template <int d>
double ImplicitShape<d>::hessian_bound(const RealBox<d>& box) const {
  using Jet = Jet1<Interval, d>;
  std::array<Jet1<Jet, d>, d> variables;
  for (int k = 0; k < d; ++k)
    variables[k] = Jet1<Jet, d>::variable(Jet::variable(Interval(box.min()[k], box.max()[k]), k), k);
  const Jet1<Jet, d> f = formula_(std::span<const Jet1<Jet, d>>(variables));
  double squared = 0;
  for (const Jet& row : f.gradient)
    for (const Interval& entry : row.gradient) squared += square(boost::numeric::norm(entry));
  return std::sqrt(squared);
}

/// Whether the distance has a local minimum at a regular foot.
template <int d>
bool ImplicitShape<d>::is_minimum(const RealPoint<d>& query, const Foot& foot) const {
  const BoundaryPoint<d> point = boundary_point(query, foot);
  const double signed_distance = (query - foot.position).dot(point.normal);
  bool minimum = true;
  for (const double k : point.curvature) minimum &= 1 + signed_distance * k > -1e-9;
  return minimum;
}

/// The closest foot on or off the rays of crossings(): after those, every box nearer than the best foot whose
/// side is not decided, down to an eighth of its distance, is searched where it holds a point of the other
/// side or is far from that foot. Nothing where that takes too many boxes to be sure.
template <int d>
auto ImplicitShape<d>::search(const RealPoint<d>& query, double within) const -> std::optional<Foot> {
  std::optional<Foot> best;
  const auto consider = [&](const RealPoint<d>& start) {
    for (const auto& foot : {newton(query, start, within), descend(query, start, within)}) {
      if (!foot || !((foot->position - query).norm() <= within * (1 + 1e-12))) continue;
      if (!foot->singular && !is_singular(foot->f) && !is_minimum(query, *foot)) continue;
      if (!best || (foot->position - query).norm() < (best->position - query).norm() - 1e-12 * size_)
        best = foot;
    }
  };
  for (const RealPoint<d>& start : crossings(query, within)) consider(start);
  consider(query);

  const auto limit = [&] { return best ? (best->position - query).norm() - 1e-9 * size_ : within; };
  const bool inside = value(query) <= 0;
  const RealPoint<d> reach = RealPoint<d>::Constant(limit());
  std::vector<RealBox<d>> boxes{{query - reach, query + reach}};
  for (int budget = 20000; !boxes.empty(); --budget) {
    if (budget == 0) return std::nullopt;
    const RealBox<d> box = boxes.back();
    boxes.pop_back();
    if (box.exteriorDistance(query) >= limit() || side_of_polynomial(box) != Side::crossing) continue;
    const RealPoint<d> middle = box.center();
    const bool other_side = (value(middle) <= 0) != inside && (middle - query).norm() < limit();
    if (other_side) {
      RealPoint<d> near = query, far = middle;
      for (int halving = 0; halving < 30; ++halving) {
        const RealPoint<d> between = (near + far) / 2;
        ((value(between) <= 0) == inside ? near : far) = between;
      }
      consider(far);
    }
    if (box.sizes()[0] > limit() / 8) {
      for (int part = 0; part < (1 << d); ++part) {
        const RealPoint<d> corner = box.corner(typename RealBox<d>::CornerType(part));
        boxes.push_back({corner.cwiseMin(middle), corner.cwiseMax(middle)});
      }
    } else if (!other_side && (!best || (middle - best->position).norm() > limit() / 2)) {
      consider(middle);
    }
  }
  return best;
}

template <int d>
BoundaryPoint<d> ImplicitShape<d>::boundary_point(const RealPoint<d>& query, const Foot& foot) const {
  const double slope = foot.f.gradient.norm();
  BoundaryPoint<d> point;
  point.position = foot.position;
  point.normal = foot.f.gradient / slope;
  // The shape operator is the Hessian on the tangent plane, over |grad f|.
  if constexpr (d == 2) {
    point.direction[0] = {-point.normal[1], point.normal[0]};
    point.curvature[0] = point.direction[0].dot(foot.f.hessian * point.direction[0]) / slope;
  } else {
    Eigen::Matrix<double, 3, 2> tangent;
    tangent.col(0) = point.normal.unitOrthogonal();
    tangent.col(1) = point.normal.cross(tangent.col(0));
    const Eigen::Matrix2d shape_operator = tangent.transpose() * foot.f.hessian * tangent / slope;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(shape_operator);
    for (int i = 0; i < 2; ++i) {
      point.curvature[i] = eigen.eigenvalues()[1 - i];
      point.direction[i] = tangent * eigen.eigenvectors().col(1 - i);
    }
  }
  const RealPoint<d> difference = query - foot.position;
  point.distance = difference.norm();
  const double tangential = (difference - difference.dot(point.normal) * point.normal).norm();
  point.residual = std::max(std::abs(foot.f.value) / slope, tangential) / size_;
  return point;
}

/// The closest point on the faces of the box that cut the shape; its curvature is 0. Nothing at a rim.
template <int d>
std::optional<BoundaryPoint<d>> ImplicitShape<d>::nearest_cut(const RealPoint<d>& query) const {
  std::optional<BoundaryPoint<d>> nearest;
  for (int axis = 0; axis < d; ++axis)
    for (const int sign : {-1, +1}) {
      BoundaryPoint<d> point;
      point.position = query;
      point.position[axis] = sign < 0 ? box_.min()[axis] : box_.max()[axis];
      if (!box_.contains(point.position) || value(point.position) > 0) continue;
      point.distance = std::abs(query[axis] - point.position[axis]);
      if (nearest && nearest->distance <= point.distance) continue;
      point.normal = RealPoint<d>::Unit(axis) * sign;
      point.curvature.fill(0);
      if constexpr (d == 2)
        point.direction[0] = {-point.normal[1], point.normal[0]};
      else
        point.direction = {point.normal.unitOrthogonal(), point.normal.cross(point.normal.unitOrthogonal())};
      point.residual = 0;
      nearest = point;
    }
  return nearest;
}

template <int d>
std::optional<BoundaryPoint<d>> ImplicitShape<d>::local_project(const RealPoint<d>& query,
                                                                double within) const {
  std::optional<BoundaryPoint<d>> cut;
  if (cut_) {
    cut = nearest_cut(query);
    if (cut && cut->distance > within) cut.reset();
    if (cut) {
      within = cut->distance;
      const RealPoint<d> reach = RealPoint<d>::Constant(within);
      if (side_of_polynomial({query - reach, query + reach}) != Side::crossing) return cut;
    }
  }
  std::optional<Foot> best = newton(query, query, within);
  if (!best || best->singular || is_singular(best->f) ||
      !((best->position - query).norm() <= within * (1 + 1e-12)) || !proves_closest(query, *best))
    best = search(query, within);
  if (best) best->singular |= is_singular(best->f);
  if (best && cut_ && !box_.contains(best->position)) {
    // The polynomial goes on beyond the cut: the closest point is on a face, or on its rim.
    best.reset();
    if (!cut) return std::nullopt;
  }
  if (cut && (!best || cut->distance < (best->position - query).norm())) return cut;
  if (!best) throw UncertifiedProjection("no closest point found on {" + formula_.text() + " <= 0}");
  if (best->singular || is_left_out(best->position)) return std::nullopt;
  return boundary_point(query, *best);
}

namespace {

/// Whether f > 0 on a whole box; gives up (false) after `budget` boxes, or at the first point where f <= 0.
template <int d>
bool proves_positive(const Formula& formula, const RealBox<d>& whole, int& budget) {
  std::vector<RealBox<d>> boxes{whole};  // a stack of its own: halving towards a zero of f goes deep
  while (!boxes.empty()) {
    if (--budget < 0) return false;
    const RealBox<d> box = boxes.back();
    boxes.pop_back();
    std::array<Interval, d> variables;
    std::array<Jet1<Interval, d>, d> jets;
    for (int k = 0; k < d; ++k) {
      variables[k] = Interval(box.min()[k], box.max()[k]);
      jets[k] = Jet1<Interval, d>::variable(variables[k], k);
    }
    if (formula(std::span<const Interval>(variables)).lower() > 0) continue;
    const RealPoint<d> middle = box.center();
    const double f = formula(std::span<const double>(middle.data(), d));
    if (!(f > 0)) return false;
    const Jet1<Interval, d> slopes = formula(std::span<const Jet1<Interval, d>>(jets));
    double lower = f;
    for (int k = 0; k < d; ++k)
      lower -= box.sizes()[k] / 2 *
               std::max(std::abs(slopes.gradient[k].lower()), std::abs(slopes.gradient[k].upper()));
    const RealPoint<d> far = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
    if (lower > 1e-13 * formula.magnitude({far.data(), d})) continue;
    int axis;
    box.sizes().maxCoeff(&axis);
    RealBox<d> left = box, right = box;
    left.max()[axis] = right.min()[axis] = middle[axis];
    boxes.push_back(right);
    boxes.push_back(left);
  }
  return true;
}

template <int d>
RealBox<d> cube(double half_side) {
  return {RealPoint<d>::Constant(-half_side), RealPoint<d>::Constant(half_side)};
}

/// The part of a box beyond `position` along an axis, on the side of `sign`.
template <int d>
RealBox<d> slab(RealBox<d> box, int axis, int sign, double position) {
  (sign > 0 ? box.min() : box.max())[axis] = position;
  return box;
}

template <int d>
bool positive_around(const Formula& formula, const RealBox<d>& inner, const RealBox<d>& outer, int budget) {
  for (int axis = 0; axis < d; ++axis)
    for (const int sign : {-1, +1}) {
      const double position = sign > 0 ? inner.max()[axis] : inner.min()[axis];
      if (!proves_positive<d>(formula, slab<d>(outer, axis, sign, position), budget)) return false;
    }
  return true;
}

/// Whether some point of a grid over the box has f <= 0.
template <int d>
bool reaches_zero(const Formula& formula, const RealBox<d>& box) {
  constexpr int kSide = d == 2 ? 200 : 40;
  bool found = false;
  const RealPoint<d> step = box.sizes() / kSide;
  for_each_point(LatticeBox<d>{LatticePoint<d>::Zero(), LatticePoint<d>::Constant(kSide)},
                 [&](const LatticePoint<d>& i) {
                   if (found) return;
                   const RealPoint<d> p = box.min() + step.cwiseProduct(i.template cast<double>());
                   found = formula(std::span<const double>(p.data(), d)) <= 0;
                 });
  return found;
}

}  // namespace

template <int d>
RealBox<d> bounds_of(const Formula& formula, double bound) {
  constexpr int kBudget = 100000;
  const auto fail = [&](const std::string& why) {
    throw InputError(fmt::format("polynomial '{}' {}", formula.text(), why));
  };
  if (formula.variables() > d) fail("has too many variables");
  std::optional<RealBox<d>> box;
  if (bound > 0) {
    if (!positive_around<d>(formula, cube<d>(bound), cube<d>(bound), kBudget))
      fail(fmt::format("is not proved positive on the border of the box of half side {}: unbounded there",
                       bound));
    box = cube<d>(bound);
  } else {
    for (double half = 1024; half >= 1.0 / 64; half /= 2)
      if (positive_around<d>(formula, cube<d>(half), cube<d>(2 * half), kBudget / 10))
        box = cube<d>(half);
      else if (box)
        break;
    if (!box) fail("is unbounded, or not proved bounded, in the box of half side 1024; try bound=");
  }
  if (!reaches_zero<d>(formula, *box))
    fail(bound > 0 ? fmt::format("is never negative in the box of half side {}: the shape is empty", bound)
                   : "is never negative: the shape is empty");
  for (int axis = 0; axis < d; ++axis)
    for (const int sign : {-1, +1}) {
      double& face = (sign > 0 ? box->max() : box->min())[axis];
      double inner = sign > 0 ? box->min()[axis] : box->max()[axis];  // never proved
      for (int halving = 0; halving < 10; ++halving) {
        const double middle = (face + inner) / 2;
        int budget = kBudget / 50;
        (proves_positive<d>(formula, slab<d>(*box, axis, sign, middle), budget) ? face : inner) = middle;
      }
    }
  return *box;
}

template class ImplicitShape<2>;
template class ImplicitShape<3>;
template RealBox<2> bounds_of<2>(const Formula&, double);
template RealBox<3> bounds_of<3>(const Formula&, double);

}  // namespace gridstep
