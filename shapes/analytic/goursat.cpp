#include "shapes/analytic/polynomial_entry.hpp"

namespace gridstep {

ShapeEntry describe_goursat() {
  return polynomial_entry("goursat", "0.03*(x^4+y^4+z^4)-2*(x^2+y^2+z^2)-8");
}

}  // namespace gridstep
