#include <fmt/format.h>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_lpball() {
  return {"lpball",
          "x^power + y^power <= radius^power",
          {Parameter::length("radius", 10, "half the width"),
           {"power", 4.0, "1", "even, so that the boundary is algebraic and smooth", 2.0, 32.0, false, true}},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            const int power = int(p["power"]);
            p.require(power % 2 == 0, "power must be even");
            const RealPoint<2> corner = RealPoint<2>::Constant(p["radius"]);
            return std::make_unique<ImplicitShape<2>>(
                centre, Formula(fmt::format("(x/{0})^{1}+(y/{0})^{1}-1", p["radius"], power)),
                RealBox<2>(-corner, corner));
          })};
}

}  // namespace gridstep
