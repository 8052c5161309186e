#include "estimators/integral_invariant/radial/radial_estimator.hpp"

namespace gridstep {

EstimatorEntry describe_ii_ho1() {
  return radial_entry("ii-ho1",
                      "ii-pf1 that does not see how curvature changes either, to second order in R: for smooth shapes, "
                      "with a greater R",
                      2);
}

}  // namespace gridstep
