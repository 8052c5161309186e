#include "estimators/contour/digital_contour.hpp"

#include <fmt/format.h>

namespace gridstep {

namespace {

/// Offsets from the inner point to the two ends. With pointel p at h (p - 1/2), the point z has its corners
/// at z + {0, 1}^2; walking with it on the left goes up beside its right face, left above its upper one.
LatticePoint<2> pointel_of(const Surfel<2>& linel, bool end) {
  const bool upper = linel.sign > 0;
  LatticePoint<2> p = linel.inner;
  p[linel.axis] += upper;
  const bool ascending = (linel.axis == 0) == upper;
  p[1 - linel.axis] += end == ascending;
  return p;
}

std::string to_string(const Surfel<2>& linel) {
  const auto k = linel.cell().coordinates;
  return fmt::format("({}, {})", k[0], k[1]);
}

}  // namespace

LatticePoint<2> start_pointel(const Surfel<2>& linel) {
  return pointel_of(linel, false);
}

LatticePoint<2> end_pointel(const Surfel<2>& linel) {
  return pointel_of(linel, true);
}

std::vector<DigitalContour> closed_contours(std::span<const Surfel<2>> linels) {
  std::vector<DigitalContour> contours;
  std::size_t first = 0;
  for (std::size_t i = 0; i < linels.size(); ++i) {
    if (i == first) contours.emplace_back();
    contours.back().pointels.push_back(start_pointel(linels[i]));
    const LatticePoint<2> end = end_pointel(linels[i]), begin = contours.back().pointels.front();
    const bool goes_on = i + 1 < linels.size() && start_pointel(linels[i + 1]) == end;
    // Where a contour touches itself or another at its first pointel, interior adjacency stays with the
    // point.
    const bool closes = end == begin && (!goes_on || linels[i].inner == linels[first].inner);
    if (closes)
      first = i + 1;
    else if (!goes_on)
      throw InputError(
          i + 1 < linels.size()
              ? fmt::format("open contour: linel {} (Khalimsky) is followed by {}, which does "
                            "not start at its end",
                            to_string(linels[i]), to_string(linels[i + 1]))
              : fmt::format("open contour: it ends with linel {} (Khalimsky), away from its start",
                            to_string(linels[i])));
  }
  return contours;
}

}  // namespace gridstep
