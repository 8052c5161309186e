#include "shapes/analytic/polynomial_entry.hpp"

namespace gridstep {

ShapeEntry describe_leopold() {
  return polynomial_entry("leopold", "x^2*y^2*z^2+4*x^2+4*y^2+3*z^2-100");
}

}  // namespace gridstep
