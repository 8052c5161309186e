#include "shapes/analytic/polar_curve.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

namespace gridstep {

using std::numbers::pi;

namespace {

/// The curve gamma(t) = rho(t) (cos t, sin t) and its derivatives.
struct CurvePoint {
  RealPoint<2> position, first, second;
};

CurvePoint curve_point(const PolarRadius& r, double t) {
  const RealPoint<2> radial(std::cos(t), std::sin(t)), across(-radial[1], radial[0]);
  return {r.rho * radial, r.first * radial + r.rho * across,
          (r.second - r.rho) * radial + 2 * r.first * across};
}

}  // namespace

RealBox<2> PolarCurve::local_bounds() const {
  return {RealPoint<2>::Constant(-bounds_.greatest), RealPoint<2>::Constant(bounds_.greatest)};
}

/// Taylor's formula for f(p) = |p| - rho(arg p) around the middle of the box. In the frame of the radius r and
/// across it, grad f = (1, -rho'/r), and the Hessian is (0, rho'/r^2; rho'/r^2, 1/r - rho''/r^2).
QuadraticBound<2> PolarCurve::local_bound(const RealBox<2>& box) const {
  const RealPoint<2> middle = box.center();
  const double reach = (box.max() - middle).cwiseMax(middle - box.min()).norm() * (1 + 1e-12);
  const double distance = middle.norm(), nearest = distance - reach;
  // Of hypot, atan2 and rho, whose derivative amplifies the rounding of the angle.
  const double slack = 1e-12 * bounds_.greatest + 1e-14 * bounds_.steepest;
  if (nearest > bounds_.greatest + slack) return QuadraticBound<2>::constant(Side::outside);
  if (distance + reach < bounds_.least - slack) return QuadraticBound<2>::constant(Side::inside);
  if (!(nearest > 0)) return QuadraticBound<2>::constant(Side::crossing);
  const double t = std::atan2(middle[1], middle[0]);
  const double angular_reach = std::asin(reach / distance) * (1 + 1e-12);
  const PolarRadius r = radius_at(t);
  const double sharpest = sharpest_around(t, angular_reach, r) * (1 + 1e-12);
  const double steepest = std::min(bounds_.steepest, std::abs(r.first) + sharpest * angular_reach);
  const RealPoint<2> radial = middle / distance, across(-radial[1], radial[0]);
  const double hessian = 1 / nearest + (sharpest + steepest) / (nearest * nearest);
  return {middle, distance - r.rho, radial - (r.first / distance) * across, RealMatrix<2>::Zero(),
          hessian * reach * reach / 2 * (1 + 1e-12) + slack};
}

std::uint64_t PolarCurve::local_inside(std::span<const RealPoint<2>> points) const {
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RealPoint<2>& p = points[i];
    const double distance = std::sqrt(p[0] * p[0] + p[1] * p[1]);
    const bool inside = distance <= bounds_.least ||
                        (distance <= bounds_.greatest && distance <= rho(std::atan2(p[1], p[0])));
    result |= std::uint64_t(inside) << i;
  }
  return result;
}

/// Every curve point at most `within` away has an angle at most asin(within / |query|) from the query's. All
/// critical points of the distance in that window are bracketed between samples close enough to separate
/// them, then solved for.
std::optional<BoundaryPoint<2>> PolarCurve::local_project(const RealPoint<2>& query, double within) const {
  const double norm = query.norm(), angle = std::atan2(query[1], query[0]);
  const double window = within < norm ? std::asin(within / norm) : pi;
  const auto slope = [&](double t) {  // half the derivative of the squared distance
    const CurvePoint c = curve_point(radius_at(t), t);
    return (c.position - query).dot(c.first);
  };
  // The speed is at least `least`; the curve turns at a rate that its second derivatives bound, and a sample
  // each tenth of a radian of turning separates critical points that are not about to merge.
  const double turning = 1 + (bounds_.sharpest + 2 * bounds_.steepest + bounds_.greatest) / bounds_.least;
  const int samples = std::clamp(int(std::ceil(2 * window * turning * 10)), 4, 20000);

  std::optional<double> best;
  double best_distance = std::numeric_limits<double>::infinity();
  const auto consider = [&](double t) {
    const double distance = (curve_point(radius_at(t), t).position - query).norm();
    if (distance < best_distance) {
      best = t;
      best_distance = distance;
    }
  };
  double left = angle - window * (1 + 1e-9) - 1e-12, left_slope = slope(left);
  const double step = 2 * (angle - left) / samples;
  for (int i = 1; i <= samples; ++i) {
    const double right = i == samples ? 2 * angle - (angle - window * (1 + 1e-9) - 1e-12) : left + step;
    const double right_slope = slope(right);
    if (left_slope == 0) consider(left);
    if (left_slope < 0 && right_slope > 0) {  // a minimum
      std::uintmax_t iterations = 60;
      const auto [a, b] =
          boost::math::tools::toms748_solve(slope, left, right, left_slope, right_slope,
                                            boost::math::tools::eps_tolerance<double>(52), iterations);
      consider(a);
      consider(b);
    }
    left = right;
    left_slope = right_slope;
  }
  if (!best) throw UncertifiedProjection("no closest point on a polar curve within the window");

  // A last Newton step brings the tangential residual to rounding level.
  double t = *best;
  {
    const CurvePoint c = curve_point(radius_at(t), t);
    const double second = c.first.squaredNorm() + (c.position - query).dot(c.second);
    const double next = t - (c.position - query).dot(c.first) / second;
    if (second > 0 && std::abs(slope(next)) < std::abs(slope(t))) t = next;
  }
  const PolarRadius r = radius_at(t);
  const CurvePoint c = curve_point(r, t);
  BoundaryPoint<2> point;
  point.position = c.position;
  const double speed_squared = r.rho * r.rho + r.first * r.first, speed = std::sqrt(speed_squared);
  point.direction[0] = c.first / speed;
  point.normal = {point.direction[0][1], -point.direction[0][0]};
  // Curvature of a polar curve [any text on plane curves]: (rho^2 + 2 rho'^2 - rho rho'') / (rho^2 +
  // rho'^2)^(3/2).
  point.curvature[0] = (r.rho * r.rho + 2 * r.first * r.first - r.rho * r.second) / (speed_squared * speed);
  const RealPoint<2> difference = query - point.position;
  point.distance = difference.norm();
  point.residual =
      std::max(std::abs(difference.dot(point.direction[0])),
               std::abs(point.position.norm() - rho(std::atan2(point.position[1], point.position[0])))) /
      size();
  return point;
}

}  // namespace gridstep
