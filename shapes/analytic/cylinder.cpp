#include <cmath>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/base/taylor_model.hpp"

namespace gridstep {

namespace {

/// The capped cylinder x^2 + y^2 <= radius^2, |z| <= half_height: flat caps, singular rims.
class Cylinder final : public Shape<3> {
 public:
  Cylinder(const RealPoint<3>& centre, double radius, double half_height)
      : Shape<3>(centre), radius_(radius), half_height_(half_height) {}

 protected:
  RealBox<3> local_bounds() const override {
    const RealPoint<3> corner(radius_, radius_, half_height_);
    return {-corner, corner};
  }
  QuadraticBound<3> local_bound(const RealBox<3>& box) const override {
    const auto [x, y, z] = TaylorModel<3>::variables(box);
    BoundOfIntersection<3> bound(box);
    bound.add(bound_of(square(x) + square(y) - TaylorModel<3>(radius_ * radius_), box));
    for (const double sign : {-1.0, 1.0}) bound.add_half_space(sign * RealPoint<3>::UnitZ(), half_height_);
    return bound.bound();
  }
  std::uint64_t local_inside(std::span<const RealPoint<3>> points) const override {
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const RealPoint<3>& p = points[i];
      result |=
          std::uint64_t(p[0] * p[0] + p[1] * p[1] <= radius_ * radius_ && std::abs(p[2]) <= half_height_)
          << i;
    }
    return result;
  }
  std::optional<BoundaryPoint<3>> local_project(const RealPoint<3>& query, double) const override {
    const double tolerance = 1e-12 * size(), axial = std::hypot(query[0], query[1]);
    const double beyond_side = axial - radius_, beyond_cap = std::abs(query[2]) - half_height_;
    // The side where the query is beyond it alone, or inside and nearer to it; a rim where it is beyond both.
    if (beyond_side > -tolerance && beyond_cap > -tolerance) return std::nullopt;
    const bool on_side = beyond_side > 0 || (beyond_cap <= 0 && beyond_side > beyond_cap);
    BoundaryPoint<3> point;
    if (on_side) {
      point.normal = RealPoint<3>(query[0] / axial, query[1] / axial, 0);
      point.position = RealPoint<3>(radius_ * point.normal[0], radius_ * point.normal[1], query[2]);
      point.curvature = {1 / radius_, 0};
      point.direction = {RealPoint<3>(-point.normal[1], point.normal[0], 0), RealPoint<3>::UnitZ()};
    } else {
      point.normal = RealPoint<3>::UnitZ() * (query[2] < 0 ? -1 : 1);
      point.position = RealPoint<3>(query[0], query[1], point.normal[2] * half_height_);
      point.curvature = {0, 0};
      point.direction = {RealPoint<3>::UnitX(), RealPoint<3>::UnitY()};
    }
    const RealPoint<3> difference = query - point.position;
    point.distance = difference.norm();
    point.residual = (difference - difference.dot(point.normal) * point.normal).norm() / size();
    return point;
  }

 private:
  double radius_, half_height_;
};

}  // namespace

ShapeEntry describe_cylinder() {
  return {"cylinder",
          "x^2 + y^2 <= radius^2 and |z| <= height / 2",
          {Parameter::length("radius", 5, "radius"), Parameter::length("height", 10, "distance of the caps")},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            return std::make_unique<Cylinder>(centre, p["radius"], p["height"] / 2);
          })};
}

}  // namespace gridstep
