#include "shapes/analytic/polynomial_entry.hpp"

namespace gridstep {

ShapeEntry describe_crixxi() {
  return polynomial_entry("crixxi", "0.9*(y^2+z^2-1)^2+(x^2+y^2-1)^3", "; singular along curves");
}

}  // namespace gridstep
