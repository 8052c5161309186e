#include <fmt/format.h>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

ShapeEntry describe_torus() {
  return {"torus",
          "(x^2 + y^2 + z^2 + major^2 - minor^2)^2 <= 4 major^2 (x^2 + y^2)",
          {Parameter::length("major", 6, "radius of the circle in the middle, around z"),
           Parameter::length("minor", 2, "radius of the tube")},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            const double major = p["major"], minor = p["minor"];
            p.require(minor < major, "minor must be smaller than major");
            const RealPoint<3> corner(major + minor, major + minor, minor);
            return std::make_unique<ImplicitShape<3>>(
                centre,
                Formula(fmt::format("(x^2+y^2+z^2+{0}*{0}-{1}*{1})^2-4*{0}*{0}*(x^2+y^2)", major, minor)),
                RealBox<3>(-corner, corner));
          })};
}

}  // namespace gridstep
