#include <fmt/format.h>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_rounded_cube() {
  return {"rounded-cube",
          "x^4 + y^4 + z^4 <= radius^4",
          {Parameter::length("radius", 9, "half the width")},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            const RealPoint<3> corner = RealPoint<3>::Constant(p["radius"]);
            return std::make_unique<ImplicitShape<3>>(
                centre, Formula(fmt::format("x^4+y^4+z^4-{}^4", p["radius"])), RealBox<3>(-corner, corner));
          })};
}

}  // namespace gridstep
