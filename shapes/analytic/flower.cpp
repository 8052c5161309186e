#include <cmath>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/polar_curve.hpp"

namespace gridstep {

namespace {

class Flower final : public PolarCurve {
 public:
  Flower(const RealPoint<2>& centre, double radius, double amplitude, double petals, double phase)
      : PolarCurve(centre,
                   {radius - amplitude, radius + amplitude, amplitude * petals, amplitude * petals * petals}),
        radius_(radius),
        amplitude_(amplitude),
        petals_(petals),
        phase_(reduced(phase)) {}

 protected:
  double rho(double t) const override { return radius_ + amplitude_ * std::cos(petals_ * t + phase_); }
  PolarRadius radius_at(double t) const override {
    const double c = amplitude_ * std::cos(petals_ * t + phase_),
                 s = amplitude_ * std::sin(petals_ * t + phase_);
    return {radius_ + c, -petals_ * s, -petals_ * petals_ * c};
  }

 private:
  /// A phase of many turns would swallow the last digits of the angle that it is added to.
  static double reduced(double phase) {
    constexpr double kMany = 100;
    return std::abs(phase) <= kMany ? phase : std::atan2(std::sin(phase), std::cos(phase));
  }

  double radius_, amplitude_, petals_, phase_;
};

}  // namespace

ShapeEntry describe_flower() {
  return {"flower",
          "|p| <= radius + amplitude cos(petals t + phase), t the polar angle",
          {Parameter::length("radius", 20, "mean radius"),
           {"amplitude", 7.0, "length", "half the range of the radius", 0.0},
           Parameter::count("petals", 6, 1, "number of petals"),
           Parameter::number("phase", 0, "radian", "phase of the petals")},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            p.require(p["amplitude"] < p["radius"], "amplitude must be smaller than radius");
            return std::make_unique<Flower>(centre, p["radius"], p["amplitude"], p["petals"], p["phase"]);
          })};
}

}  // namespace gridstep
