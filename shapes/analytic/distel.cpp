#include "shapes/analytic/polynomial_entry.hpp"

namespace gridstep {

ShapeEntry describe_distel() {
  return polynomial_entry("distel", "x^2+y^2+z^2+1000*(x^2+y^2)*(x^2+z^2)*(y^2+z^2)-10000",
                          "; spikes along the axes");
}

}  // namespace gridstep
