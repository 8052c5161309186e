#include "estimators/integral_invariant/radial/radial_estimator.hpp"

namespace gridstep {

EstimatorEntry describe_ii_pf1() {
  return radial_entry(
      "ii-pf1",
      "integral invariant that does not see how far a surfel is from the boundary: curvature (2D), all "
      "curvatures, principal directions and the normal (3D)",
      {.vanishing = 1, .usual_k_2d = 5, .usual_k_3d = 4});
}

}  // namespace gridstep
