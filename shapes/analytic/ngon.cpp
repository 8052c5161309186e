#include <cmath>
#include <numbers>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/convex_polytope.hpp"

namespace gridstep {

ShapeEntry describe_ngon() {
  return {"ngon",
          "the regular polygon with `sides` sides and a corner at angle",
          {Parameter::length("radius", 10, "of the circle through the corners"),
           Parameter::count("sides", 5, 3, "number of sides"),
           Parameter::number("angle", 0, "radian", "of the first corner")},
          ShapeFactory<2>([](const ParameterValues& p, const RealPoint<2>& centre) {
            const double half = std::numbers::pi / p["sides"], radius = p["radius"];
            std::vector<ConvexPolytope<2>::Face> faces;
            RealBox<2> bounds;
            for (int i = 0; i < int(p["sides"]); ++i) {
              const double corner = p["angle"] + 2 * i * half, middle = corner + half;
              faces.push_back({{std::cos(middle), std::sin(middle)}, radius * std::cos(half)});
              bounds.extend(RealPoint<2>(radius * std::cos(corner), radius * std::sin(corner)));
            }
            return std::make_unique<ConvexPolytope<2>>(centre, std::move(faces), bounds);
          })};
}

}  // namespace gridstep
