#include "estimators/surface/constant_current.hpp"
#include "estimators/surface/corrected_current.hpp"

namespace gridstep {

EstimatorEntry describe_ccnc() {
  return corrected_current_estimator<ConstantCurrent>(
      "ccnc", "corrected curvature measures, normals by integral invariants and constant on faces");
}

}  // namespace gridstep
