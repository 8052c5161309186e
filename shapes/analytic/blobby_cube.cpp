#include "shapes/analytic/polynomial_entry.hpp"

namespace gridstep {

ShapeEntry describe_blobby_cube() {
  return polynomial_entry("blobby-cube", "81*(x^4+y^4+z^4)-45*(x^2+y^2+z^2)-6");
}

}  // namespace gridstep
