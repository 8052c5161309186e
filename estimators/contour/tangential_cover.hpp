#pragma once

#include <vector>

#include "estimators/contour/digital_contour.hpp"
#include "estimators/contour/straight_segment.hpp"

namespace gridstep {

/// A digital straight segment of a contour that can be extended at neither end: pointels first to last, both
/// included, and its line of least thickness, of direction (b, a) in the order of the walk.
struct MaximalSegment {
  std::ptrdiff_t first, last;
  DigitalLine line;
};

/// Half-open range of indices, counted around.
struct CyclicRange {
  std::ptrdiff_t begin, end;
};

/// The tangential cover: all maximal segments of a closed contour, in its order [Feschet & Tougne, DGCI 1999;
/// Lachaud, Vialard & de Vieilleville, IVC 2007]. Every linel is in one at least, and consecutive ones share
/// a linel.
class TangentialCover {
 public:
  /// Cost O(pointels).
  /// @throws ContractViolation where the contour is not closed, or goes back on a step.
  explicit TangentialCover(const DigitalContour& contour);

  std::ptrdiff_t size() const { return std::ptrdiff_t(segments_.size()); }
  /// Number of linels, and of pointels, of the contour.
  std::ptrdiff_t linels() const { return linels_; }
  /// Segment k, counted around the contour: 0 <= first < linels() for 0 <= k < size(), and first and last
  /// are linels() more for k + size().
  MaximalSegment operator[](std::ptrdiff_t k) const;

  /// The linels for which segment k is the most centred one: min(i - first, last - 1 - i) is largest at linel
  /// i, and a tie is for the earlier segment. The ranges of k = 0 to size() - 1 follow each other, are not
  /// empty, and go once around.
  CyclicRange most_centred_for(std::ptrdiff_t k) const;

  /// The segments that contain both ends of linel i, for every i: -size() <= begin < end <= size(). Cost
  /// O(linels + segments).
  std::vector<CyclicRange> segments_of_linels() const;

 private:
  std::ptrdiff_t linels_;
  std::vector<MaximalSegment> segments_;
};

}  // namespace gridstep
