#include <fmt/format.h>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_ellipsoid() {
  return {"ellipsoid",
          "(x/a)^2 + (y/b)^2 + (z/c)^2 <= 1",
          {Parameter::length("a", 9, "semi-axis along x"), Parameter::length("b", 7, "semi-axis along y"),
           Parameter::length("c", 5, "semi-axis along z")},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            const RealPoint<3> corner(p["a"], p["b"], p["c"]);
            return std::make_unique<ImplicitShape<3>>(
                centre, Formula(fmt::format("(x/{})^2+(y/{})^2+(z/{})^2-1", p["a"], p["b"], p["c"])),
                RealBox<3>(-corner, corner));
          })};
}

}  // namespace gridstep
