#pragma once

#include <cmath>

#include "estimators/contour/tangential_cover.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// How the contour leaves a maximal segment: +1 to the left at both ends, as around a convex part of the set,
/// -1 to the right at both, 0 at an inflection.
int turn(const DigitalContour& contour, const MaximalSegment& segment);

/// Length of the chord between the ends of a segment, squared, in cells.
inline double squared_chord(const DigitalContour& contour, const MaximalSegment& segment) {
  return (contour[segment.last] - contour[segment.first]).cast<double>().squaredNorm();
}

/// kappa[p] = turn / (h r(segment)) at every pointel p, with the maximal segment that is the most centred one
/// for the linel that ends at p, and its radius r in cells. Among the pointel's two linels this is the choice
/// of the reference library, whose values these are to be. Cost O(pointels).
template <class Radius>
void curvature_from_maximal_segments(const DigitalContour& contour, GridStep h, Radius radius,
                                     std::vector<double>& kappa) {
  const TangentialCover cover(contour);
  for (std::ptrdiff_t k = 0; k < cover.size(); ++k) {
    const MaximalSegment segment = cover[k];
    const int sign = turn(contour, segment);
    const double value = sign == 0 ? 0 : sign / (h.value * radius(segment));
    const CyclicRange linels = cover.most_centred_for(k);
    for (std::ptrdiff_t i = linels.begin; i < linels.end; ++i)
      kappa[std::size_t(contour.index(i + 1))] = value;
  }
}

}  // namespace gridstep
