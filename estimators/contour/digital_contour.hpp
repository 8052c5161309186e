#pragma once

#include <span>
#include <vector>

#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// A closed digital contour with the set on its left: linel i goes from pointel i to pointel i + 1 by one
/// unit step, and the last linel ends at pointel 0.
struct DigitalContour {
  /// In units of the grid step: the pointel with Khalimsky coordinates 2p, which lies at h (p - 1/2).
  std::vector<LatticePoint<2>> pointels;

  std::ptrdiff_t size() const { return std::ptrdiff_t(pointels.size()); }
  /// Any index, counted around the contour, as one of 0 to size() - 1.
  std::ptrdiff_t index(std::ptrdiff_t i) const {
    const std::ptrdiff_t n = size();
    return i >= 0 && i < n ? i : (i % n + n) % n;
  }
  /// The pointel with any index, counted around the contour.
  const LatticePoint<2>& operator[](std::ptrdiff_t i) const { return pointels[std::size_t(index(i))]; }
  /// Direction of linel i.
  LatticePoint<2> step(std::ptrdiff_t i) const { return (*this)[i + 1] - (*this)[i]; }
};

/// The pointel at which a linel starts, walking with the set on the left.
LatticePoint<2> start_pointel(const Surfel<2>& linel);
/// The pointel at which it ends.
LatticePoint<2> end_pointel(const Surfel<2>& linel);

/// Splits a range of linels into its closed contours, in the order of the range: linel i of the range is
/// linel i - (linels before) of its contour. Contours are those of connected_boundary() with interior
/// adjacency. Cost O(linels).
/// @throws InputError where a contour does not close; the linel and its successor are named.
std::vector<DigitalContour> closed_contours(std::span<const Surfel<2>> linels);

}  // namespace gridstep
