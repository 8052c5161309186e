#include <fmt/format.h>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_astroid() {
  return {"astroid",
          "|x|^(2/3) + |y|^(2/3) <= radius^(2/3); four cusps",
          {Parameter::length("radius", 10, "distance of the cusps")},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            const RealPoint<2> corner = RealPoint<2>::Constant(p["radius"]);
            // The equation without roots, in units of the radius.
            return std::make_unique<ImplicitShape<2>>(
                centre, Formula(fmt::format("((x/{0})^2+(y/{0})^2-1)^3+27*(x/{0})^2*(y/{0})^2", p["radius"])),
                RealBox<2>(-corner, corner));
          })};
}

}  // namespace gridstep
