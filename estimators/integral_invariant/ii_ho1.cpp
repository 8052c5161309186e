#include "estimators/integral_invariant/radial/radial_estimator.hpp"

namespace gridstep {

EstimatorEntry describe_ii_ho1() {
  return radial_entry(
      "ii-ho1",
      "ii-pf1 that does not see how curvature changes either, to second order in R: for smooth shapes, "
      "with a greater R",
      {.vanishing = 2, .usual_k_2d = 8, .usual_k_3d = 6.75});
}

}  // namespace gridstep
