#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_polynomial() {
  return {"polynomial",
          "formula <= 0, a polynomial in x, y, z",
          {{"formula", std::string("x^2+y^2+z^2-25"), "text", "numbers, x, y, z, + - * ^ and parentheses"},
           {"bound", 0.0, "length", "half side of a box known to contain the shape; 0: found", 0.0}},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            Formula formula(p.text("formula"));
            const RealBox<3> box = bounds_of<3>(formula, p["bound"]);
            return std::make_unique<ImplicitShape<3>>(centre, std::move(formula), box);
          })};
}

}  // namespace gridstep
