#pragma once

#include <functional>

#include "shapes/analytic/shape.hpp"

namespace gridstep {

/// rho and its derivatives at an angle.
struct PolarRadius {
  double rho, first, second;
};

/// The region |p| <= rho(t), t = atan2(y, x), of a positive, 2 pi-periodic function with two continuous
/// derivatives.
class PolarCurve : public Shape<2> {
 public:
  struct Bounds {
    double least, greatest;     ///< of rho
    double steepest, sharpest;  ///< of |rho'| and of |rho''|
  };

  PolarCurve(const RealPoint<2>& centre, const Bounds& bounds) : Shape<2>(centre), bounds_(bounds) {}

 protected:
  virtual PolarRadius radius_at(double t) const = 0;
  /// rho alone: what inside() compares with.
  virtual double rho(double t) const = 0;
  /// A bound on |rho''| at the angles within `reach` of t in [-pi, pi], where the radius is `r`; a tight one
  /// saves work.
  virtual double sharpest_around(double /*t*/, double /*reach*/, const PolarRadius& /*r*/) const {
    return bounds_.sharpest;
  }

  RealBox<2> local_bounds() const override;
  QuadraticBound<2> local_bound(const RealBox<2>& box) const override;
  std::uint64_t local_inside(std::span<const RealPoint<2>> points) const override;
  std::optional<BoundaryPoint<2>> local_project(const RealPoint<2>& query, double within) const override;

 private:
  Bounds bounds_;
};

}  // namespace gridstep
