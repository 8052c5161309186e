#include "shapes/analytic/ball.hpp"
#include "shapes/analytic/catalogue.hpp"

namespace gridstep {

ShapeEntry describe_sphere() {
  return {"sphere",
          "x^2+y^2+z^2 <= radius^2",
          {Parameter::length("radius", 5, "radius")},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            return std::make_unique<Ball<3>>(centre, p["radius"]);
          })};
}

}  // namespace gridstep
