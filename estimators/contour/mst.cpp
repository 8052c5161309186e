#include <cmath>

#include "estimators/contour/contour_estimator.hpp"
#include "estimators/contour/tangential_cover.hpp"

namespace gridstep {

namespace {

/// Tangent: the direction (b, a) of the maximal segment that is the most centred one for the linel.
///   Units  a unit vector, walking with the set on the left. At linel centres.
///   Bound  no rate of its sup error is proven. It is exact in the middle of long straight sides, save those
///          along an axis: their maximal segments end with a step across.
///   Cost   O(linels).
/// [Feschet & Tougne, DGCI 1999]
void tangent(const DigitalContour& contour, GridStep, std::vector<std::vector<double>>& columns) {
  const TangentialCover cover(contour);
  for (std::ptrdiff_t k = 0; k < cover.size(); ++k) {
    const DigitalLine line = cover[k].line;
    const double norm = std::sqrt(double(line.a * line.a + line.b * line.b));
    const CyclicRange linels = cover.most_centred_for(k);
    for (std::ptrdiff_t i = linels.begin; i < linels.end; ++i) {
      columns[0][std::size_t(contour.index(i))] = double(line.b) / norm;
      columns[1][std::size_t(contour.index(i))] = double(line.a) / norm;
    }
  }
}

}  // namespace

EstimatorEntry describe_mst() {
  return contour_estimator("mst", "tangent of the most centred maximal digital straight segment",
                           {{"tangent_x", std::nullopt}, {"tangent_y", std::nullopt}},
                           ValuePosition::surfel_centre, tangent);
}

}  // namespace gridstep
