#include <fmt/format.h>

#include <cmath>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_lemniscate() {
  return {"lemniscate",
          "(x^2 + y^2)^2 <= radius^2 (x^2 - y^2), Bernoulli's; crosses itself at the centre",
          {Parameter::length("radius", 10, "half the width")},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            const double radius = p["radius"];
            const RealPoint<2> corner(radius, radius / std::sqrt(8.0) * (1 + 1e-12));
            return std::make_unique<ImplicitShape<2>>(
                centre, Formula(fmt::format("((x/{0})^2+(y/{0})^2)^2-(x/{0})^2+(y/{0})^2", radius)),
                RealBox<2>(-corner, corner));
          })};
}

}  // namespace gridstep
