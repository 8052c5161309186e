#include <cmath>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/convex_polytope.hpp"

namespace gridstep {

ShapeEntry describe_square() {
  return {"square",
          "max(|x'|, |y'|) <= side / 2 in axes turned by angle",
          {Parameter::length("side", 10, "length of a side"),
           Parameter::number("angle", 0, "radian", "from x to x', counterclockwise")},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            const double c = std::cos(p["angle"]), s = std::sin(p["angle"]), half = p["side"] / 2;
            const RealPoint<2> reach = RealPoint<2>::Constant(half * (std::abs(c) + std::abs(s)));
            return std::make_unique<ConvexPolytope<2>>(
                centre,
                std::vector<ConvexPolytope<2>::Face>{
                    {{c, s}, half}, {{-s, c}, half}, {{-c, -s}, half}, {{s, -c}, half}},
                RealBox<2>(-reach, reach));
          })};
}

}  // namespace gridstep
