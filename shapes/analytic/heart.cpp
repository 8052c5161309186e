#include "shapes/analytic/polynomial_entry.hpp"

namespace gridstep {

/// Its boundary has a dip and a tip, where curvature is infinite: at the two points of the z axis at the distance
/// `radius`. Errors are only comparable `away` from them. On the ellipse z = 0 the gradient of the polynomial vanishes,
/// but the boundary is smooth: only where Newton's method cannot resolve it is there no truth.
ShapeEntry describe_heart() {
  return {"heart",
          "(x^2+2.25*y^2+z^2-1)^3-x^2*z^3-0.1125*y^2*z^3 <= 0, enlarged by radius; singular at two points on "
          "the z axis",
          {Parameter::length("radius", 1, "distance of the singular points from the centre"),
           {"away", 0.0, "length", "closest points within this distance of a singular one count as singular",
            0.0}},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            const RealPoint<3> tip(0, 0, p["radius"]);
            return enlarged_polynomial("(x^2+2.25*y^2+z^2-1)^3-x^2*z^3-0.1125*y^2*z^3", p["radius"], centre,
                                       {{tip, -tip}, p["away"]});
          })};
}

}  // namespace gridstep
