#pragma once

// Contours for the tests of this folder.

#include <cmath>
#include <numbers>
#include <numeric>

#include "estimators/catalogue.hpp"
#include "estimators/contour/digital_contour.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {

inline std::vector<DigitalContour> contours_of(const DigitalSet<2>& set) {
  return closed_contours(connected_boundary(set).surfels);
}

/// The linels of the largest contour of a set that changes its kind with the seed: scattered cells, a disk, a
/// convex polygon (long segments of many slopes), or a thin bar. The convex ones have at most 8 size + 4
/// linels.
inline std::vector<Surfel<2>> random_linels(std::uint64_t seed, int size) {
  RandomStream random({seed, 7});
  const LatticeBox<2> box{LatticePoint<2>{-size, -size}, LatticePoint<2>{size, size}};
  const auto between = [&](double lo, double hi) { return lo + (hi - lo) * random.uniform(); };
  while (true) {
    DigitalSet<2> set(box);
    if (seed % 4 == 0) {
      set = random_set<2>({LatticePoint<2>{-5, -5}, LatticePoint<2>{5, 5}}, 0.7, random.bits());
    } else if (seed % 4 == 1) {
      const double x = between(-1, 1), y = between(-1, 1), r = between(0.3, 0.9) * size;
      set = set_where<2>(box, [&](const LatticePoint<2>& z) { return std::hypot(z[0] - x, z[1] - y) <= r; });
    } else {
      const double t = between(0, 7);
      const int sides = seed % 4 == 2 ? 3 + int(random.below(5)) : 4;
      std::vector<double> u, v, d;
      for (int i = 0; i < sides; ++i) {
        const double angle = sides == 4 ? t + i * std::numbers::pi / 2 : between(0, 2 * std::numbers::pi);
        u.push_back(std::cos(angle));
        v.push_back(std::sin(angle));
        d.push_back(seed % 4 == 3 && i % 2 == 0 ? between(0.2, 1.5) : between(0.3, 0.8) * size);
      }
      set = set_where<2>(box, [&](const LatticePoint<2>& z) {
        for (int i = 0; i < sides; ++i)
          if (u[std::size_t(i)] * z[0] + v[std::size_t(i)] * z[1] > d[std::size_t(i)]) return false;
        return true;
      });
    }
    if (set.size() == 0) continue;
    DigitalSurface<2> surface = connected_boundary(set);
    surface.surfels.resize(surface.component_begin[1]);
    return surface.surfels;
  }
}

inline DigitalContour random_contour(std::uint64_t seed, int size) {
  return closed_contours(random_linels(seed, size)).front();
}

/// The contour with another first pointel.
inline DigitalContour started_at(const DigitalContour& contour, std::ptrdiff_t start) {
  DigitalContour result;
  for (std::ptrdiff_t i = 0; i < contour.size(); ++i) result.pointels.push_back(contour[start + i]);
  return result;
}

/// The linel turned by 90 degrees about the digital point 0.
inline Surfel<2> turned(const Surfel<2>& linel) {
  const std::int8_t sign = linel.axis == 0 ? linel.sign : std::int8_t(-linel.sign);
  return {{-linel.inner[1], linel.inner[0]}, std::int8_t(1 - linel.axis), sign};
}

/// What a 2D estimator of contours, found by its name, makes of linels.
inline Estimates estimate(const std::string& name, const std::vector<Surfel<2>>& linels, double h) {
  const DigitalSet<2> unused({LatticePoint<2>{0, 0}, LatticePoint<2>{0, 0}});
  auto estimator = find_estimator(name).variant<2>().make(unused, {});
  estimator->init(GridStep{h}, EuclideanLength{1});
  return estimator->eval(linels);
}

/// All primitive (a, b) with |a| + |b| <= bound, by increasing |a| + |b|.
inline std::vector<std::pair<int, int>> primitive_vectors(int bound) {
  std::vector<std::pair<int, int>> vectors;
  for (int omega = 1; omega <= bound; ++omega)
    for (int a = -omega; a <= omega; ++a)
      for (const int sign : {-1, 1}) {
        const int b = sign * (omega - std::abs(a));
        if (std::gcd(a, b) == 1 && (b != 0 || sign > 0)) vectors.emplace_back(a, b);
      }
  return vectors;
}

}  // namespace gridstep
