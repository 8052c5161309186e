#include "estimators/contour/contour_estimator.hpp"
#include "estimators/contour/mdss.hpp"

namespace gridstep {

namespace {

/// Curvature from the length of maximal segments, each taken for the chord of a circle that is one cell away
/// from it: with L the distance of its end pointels in cells,
///   kappa = +-1 / (h (L^2/8 + 1/2)).
///   Units  1/length; positive where the contour turns left at both ends of the segment (convex set),
///   negative
///          where it turns right at both, 0 at inflections. At starting pointels.
///   Bound  none: maximal segments are too short, and the values diverge as h -> 0.
///   Cost   O(linels).
/// [Coeurjolly, Miguet & Tougne, IWVF 2001; Coeurjolly & Svensson, SCIA 2003]
void curvature(const DigitalContour& contour, GridStep h, std::vector<std::vector<double>>& columns) {
  const auto radius = [&](const MaximalSegment& segment) {
    return squared_chord(contour, segment) / 8 + 0.5;
  };
  curvature_from_maximal_segments(contour, h, radius, columns[0]);
}

}  // namespace

EstimatorEntry describe_mdss_length() {
  return contour_estimator("mdss-length", "curvature from the length of maximal digital straight segments",
                           {{"kappa", std::nullopt}}, ValuePosition::start_pointel, curvature);
}

}  // namespace gridstep
