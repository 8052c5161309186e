#pragma once

#include <algorithm>
#include <vector>

#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// Distinct points, and for each request the position of its point among them.
template <int d>
struct DistinctPoints {
  std::vector<LatticePoint<d>> points;

  explicit DistinctPoints(std::vector<LatticePoint<d>> all) : points(std::move(all)) {
    std::sort(points.begin(), points.end(), raster_less<d>);
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
  std::size_t position(const LatticePoint<d>& z) const {
    return std::size_t(std::lower_bound(points.begin(), points.end(), z, raster_less<d>) - points.begin());
  }
};

/// The spel from which the offsets of a surfel-centred kernel are taken.
template <int d>
LatticePoint<d> lower_spel(const Surfel<d>& surfel) {
  return surfel.sign > 0 ? surfel.inner : surfel.outer();
}

}  // namespace gridstep
