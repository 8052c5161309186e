#include <fmt/format.h>

#include <cmath>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_ellipse() {
  return {"ellipse",
          "(x'/a)^2 + (y'/b)^2 <= 1 in axes turned by angle",
          {Parameter::length("a", 20, "semi-axis along x'"), Parameter::length("b", 7, "semi-axis along y'"),
           Parameter::number("angle", 0, "radian", "from x to x', counterclockwise")},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            const double a = p["a"], b = p["b"], c = std::cos(p["angle"]), s = std::sin(p["angle"]);
            const RealPoint<2> reach(std::hypot(a * c, b * s), std::hypot(a * s, b * c));
            return std::make_unique<ImplicitShape<2>>(
                centre, Formula(fmt::format("(({0}*x+{1}*y)/{2})^2+(({0}*y-{1}*x)/{3})^2-1", c, s, a, b)),
                RealBox<2>(-reach, reach));
          })};
}

}  // namespace gridstep
