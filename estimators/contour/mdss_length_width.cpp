#include "estimators/contour/contour_estimator.hpp"
#include "estimators/contour/mdss.hpp"

namespace gridstep {

namespace {

/// Curvature from the length and the width of maximal segments: that of the circle with the chord L between
/// the end pointels and the sagitta w, both in cells,
///   kappa = +-1 / (h (L^2/(8w) + w/2)).
/// w is the distance of the leaning lines. Both have pointels: the remainders a x - b y of a segment begin
/// with mu and end with mu + |a| + |b| - 1, and one cell across the segment is worth sqrt(a^2 + b^2) of them,
/// so
///   w = (|a| + |b| - 1) / sqrt(a^2 + b^2).
/// Maximal segments have steps of two directions, so 1/sqrt(2) <= w < sqrt(2); w = 1 is mdss-length.
///   Units  1/length; sign and position as for mdss-length.
///   Bound  none: it diverges as mdss-length does, w being of order 1.
///   Cost   O(linels).
/// [Coeurjolly & Svensson, SCIA 2003]
void curvature(const DigitalContour& contour, GridStep h, std::vector<std::vector<double>>& columns) {
  const auto radius = [&](const MaximalSegment& segment) {
    const DigitalLine& line = segment.line;
    const double w = double(line.thickness() - 1) / std::sqrt(double(line.a * line.a + line.b * line.b));
    return squared_chord(contour, segment) / (8 * w) + w / 2;
  };
  curvature_from_maximal_segments(contour, h, radius, columns[0]);
}

}  // namespace

EstimatorEntry describe_mdss_length_width() {
  return contour_estimator("mdss-length-width",
                           "curvature from the length and width of maximal digital straight segments",
                           {{"kappa", std::nullopt}}, ValuePosition::start_pointel, curvature);
}

}  // namespace gridstep
