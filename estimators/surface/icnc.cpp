#include "estimators/surface/corrected_current.hpp"
#include "estimators/surface/interpolated_current.hpp"

namespace gridstep {

EstimatorEntry describe_icnc() {
  return corrected_current_estimator<InterpolatedCurrent>(
      "icnc", "corrected curvature measures, normals by integral invariants and interpolated from vertices");
}

}  // namespace gridstep
