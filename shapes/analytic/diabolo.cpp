#include <fmt/format.h>

#include <cmath>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_diabolo() {
  return {"diabolo",
          "(y^2 + z^2)^2 <= x^2 and |x| <= length: two paraboloids that touch at the centre, with flat caps",
          {Parameter::length("length", 1, "from the centre to a cap")},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            // Room around the rims, so that only the caps cut.
            const double length = p["length"], rim = std::sqrt(length) * 1.01;
            const RealPoint<3> corner(length, rim, rim);
            return std::make_unique<ImplicitShape<3>>(centre, Formula("(y^2+z^2)^2-x^2"),
                                                      RealBox<3>(-corner, corner), true);
          })};
}

}  // namespace gridstep
