#include <cmath>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/convex_polytope.hpp"

namespace gridstep {

ShapeEntry describe_l1ball() {
  return {"l1ball",
          "|x| + |y| + |z| <= radius, the octahedron",
          {Parameter::length("radius", 10, "distance of the corners")},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            const RealPoint<3> corner = RealPoint<3>::Constant(p["radius"]);
            std::vector<ConvexPolytope<3>::Face> faces;
            for (int octant = 0; octant < 8; ++octant)
              faces.push_back({RealPoint<3>(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1) /
                                   std::sqrt(3.0),
                               p["radius"] / std::sqrt(3.0)});
            return std::make_unique<ConvexPolytope<3>>(centre, std::move(faces), RealBox<3>(-corner, corner));
          })};
}

}  // namespace gridstep
