#include "shapes/analytic/polynomial_entry.hpp"

namespace gridstep {

ShapeEntry describe_heart() {
  return polynomial_entry("heart", "(x^2+2.25*y^2+z^2-1)^3-x^2*z^3-0.1125*y^2*z^3",
                          "; singular at two points on the z axis");
}

}  // namespace gridstep
