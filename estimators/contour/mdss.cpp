#include "estimators/contour/mdss.hpp"

namespace gridstep {

int turn(const DigitalContour& contour, const MaximalSegment& segment) {
  // Pointels next to a maximal segment are off its line: they could be added otherwise.
  const DigitalLine& line = segment.line;
  const bool left_before = line.remainder(contour[segment.first - 1]) < line.mu;
  const bool left_after = line.remainder(contour[segment.last + 1]) < line.mu;
  return left_before != left_after ? 0 : left_before ? +1 : -1;
}

}  // namespace gridstep
