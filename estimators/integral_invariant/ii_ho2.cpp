#include "estimators/integral_invariant/radial/radial_estimator.hpp"

namespace gridstep {

EstimatorEntry describe_ii_ho2() {
  return radial_entry(
      "ii-ho2",
      "ii-ho1 with one more vanishing moment: least sup errors at fine grid steps, with a still greater R",
      {.vanishing = 3, .usual_k_2d = 11, .usual_k_3d = 10});
}

}  // namespace gridstep
