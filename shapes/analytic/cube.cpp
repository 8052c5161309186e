#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/convex_polytope.hpp"

namespace gridstep {

ShapeEntry describe_cube() {
  return {"cube",
          "max(|x|, |y|, |z|) <= side / 2",
          {Parameter::length("side", 10, "length of an edge")},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            const RealPoint<3> corner = RealPoint<3>::Constant(p["side"] / 2);
            std::vector<ConvexPolytope<3>::Face> faces;
            for (int axis = 0; axis < 3; ++axis)
              for (const int sign : {-1, +1}) faces.push_back({sign * RealPoint<3>::Unit(axis), corner[0]});
            return std::make_unique<ConvexPolytope<3>>(centre, std::move(faces), RealBox<3>(-corner, corner));
          })};
}

}  // namespace gridstep
