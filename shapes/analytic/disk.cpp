#include "shapes/analytic/ball.hpp"
#include "shapes/analytic/catalogue.hpp"

namespace gridstep {

ShapeEntry describe_disk() {
  return {"disk",
          "x^2+y^2 <= radius^2",
          {Parameter::length("radius", 5, "radius")},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            return std::make_unique<Ball<2>>(centre, p["radius"]);
          })};
}

}  // namespace gridstep
