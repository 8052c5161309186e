#pragma once

#include <numeric>

#include "shapes/analytic/shape.hpp"
#include "shapes/base/taylor_model.hpp"

namespace gridstep {

/// The closed ball x.x <= radius^2: everything about it is known in closed form.
template <int d>
class Ball final : public Shape<d> {
 public:
  Ball(const RealPoint<d>& centre, double radius) : Shape<d>(centre), radius_(radius) {}

 protected:
  RealBox<d> local_bounds() const override {
    return {RealPoint<d>::Constant(-radius_), RealPoint<d>::Constant(radius_)};
  }
  QuadraticBound<d> local_bound(const RealBox<d>& box) const override {
    TaylorModel<d> squared;
    for (const TaylorModel<d>& x : TaylorModel<d>::variables(box)) squared = squared + square(x);
    return bound_of(squared - TaylorModel<d>(radius_ * radius_), box);
  }
  std::uint64_t local_inside(std::span<const RealPoint<d>> points) const override {
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      double squared = 0;
      for (int k = 0; k < d; ++k) squared += points[i][k] * points[i][k];
      result |= std::uint64_t(squared <= radius_ * radius_) << i;
    }
    return result;
  }
  std::optional<BoundaryPoint<d>> local_project(const RealPoint<d>& query, double) const override {
    const double norm = query.norm();
    if (norm == 0) return std::nullopt;  // every boundary point is closest
    BoundaryPoint<d> foot;
    foot.normal = query / norm;
    foot.position = radius_ * foot.normal;
    foot.curvature.fill(1 / radius_);
    if constexpr (d == 2) {
      foot.direction = {RealPoint<d>(-foot.normal[1], foot.normal[0])};
    } else {
      foot.direction[0] = foot.normal.unitOrthogonal();
      foot.direction[1] = foot.normal.cross(foot.direction[0]);
    }
    foot.distance = std::abs(norm - radius_);
    const RealPoint<d> difference = query - foot.position;
    const double tangential = (difference - difference.dot(foot.normal) * foot.normal).norm();
    foot.residual = std::max(std::abs(foot.position.norm() - radius_), tangential) / this->size();
    return foot;
  }

 private:
  double radius_;
};

}  // namespace gridstep
