#include <cmath>
#include <numbers>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/polar_curve.hpp"

namespace gridstep {

namespace {

using std::numbers::pi;

/// With an integer number of petals both ends t = +-pi meet with two continuous derivatives: rho is even, and
/// rho' is 0 there.
class AcceleratedFlower final : public PolarCurve {
 public:
  AcceleratedFlower(const RealPoint<2>& centre, double radius, double amplitude, double petals)
      : PolarCurve(centre, bounds(radius, amplitude, 2 * petals / (pi * pi), pi)),
        radius_(radius),
        amplitude_(amplitude),
        rate_(2 * petals / (pi * pi)) {}

 protected:
  double rho(double t) const override { return radius_ + amplitude_ * std::cos(rate_ * t * t * t); }
  PolarRadius radius_at(double t) const override {
    t = std::remainder(t, 2 * pi);
    const double u = rate_ * t * t * t, first = 3 * rate_ * t * t, second = 6 * rate_ * t;
    const double c = amplitude_ * std::cos(u), s = amplitude_ * std::sin(u);
    return {radius_ + c, -s * first, -c * first * first - s * second};
  }
  double sharpest_around(double t, double reach, const PolarRadius&) const override {
    return bounds(radius_, amplitude_, rate_, std::min(std::abs(t) + reach, pi)).sharpest;
  }

 private:
  /// For |t| <= limit: the derivatives of the phase grow with |t|.
  static Bounds bounds(double radius, double amplitude, double rate, double limit) {
    const double first = 3 * rate * limit * limit, second = 6 * rate * limit;
    return {radius - amplitude, radius + amplitude, amplitude * first, amplitude * (first * first + second)};
  }

  double radius_, amplitude_, rate_;
};

}  // namespace

ShapeEntry describe_accflower() {
  return {"accflower",
          "|p| <= radius + amplitude cos((2 petals / pi^2) t^3), t in [-pi, pi) the polar angle",
          {Parameter::length("radius", 20, "mean radius"),
           {"amplitude", 7.0, "length", "half the range of the radius", 0.0},
           Parameter::count("petals", 3, 1, "the phase runs through `petals` turns on each side")},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            p.require(p["amplitude"] < p["radius"], "amplitude must be smaller than radius");
            return std::make_unique<AcceleratedFlower>(centre, p["radius"], p["amplitude"], p["petals"]);
          })};
}

}  // namespace gridstep
