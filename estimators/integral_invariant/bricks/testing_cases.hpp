#pragma once

// Random cases for comparing `bricks` with `full`: in a test by the hundred, in bench/ by the million.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "estimators/integral_invariant/bricks/ball_sums.hpp"
#include "estimators/integral_invariant/indicator.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep::bricks {

template <int d>
struct RandomCase {
  DigitalSet<d> set;
  DigitalLength radius;
  int half_axis;
  std::vector<LatticePoint<d>> spels;  // distinct, in raster order
  std::string description;
};

template <int d>
LatticePoint<d> random_point(RandomStream& random, int reach) {
  LatticePoint<d> z;
  for (int k = 0; k < d; ++k) z[k] = int(random.below(std::uint32_t(2 * reach + 1))) - reach;
  return z;
}

/// Where the closed ball is delicate: an integer, the root of a sum of squares, or anything.
inline double random_radius(RandomStream& random, int largest) {
  const double r = 1 + random.uniform() * (largest - 1);
  switch (random.below(4)) {
    case 0:
      return std::floor(r);
    case 1:
      return std::sqrt(std::floor(r * r));
    default:
      return r;
  }
}

/// A set in a box of random place and size, which in one case in four fills its domain to the border.
template <int d>
DigitalSet<d> random_digital_set(RandomStream& random, int largest_side, std::string& description) {
  LatticeBox<d> box{random_point<d>(random, 90), {}};
  for (int k = 0; k < d; ++k) box.hi[k] = box.lo[k] + int(random.below(std::uint32_t(largest_side)));
  if (random.below(4) == 0) {  // up to a corner of its domain, which is made of whole pages
    constexpr int kPage = DigitalSet<d>::kPageSide;
    for (int k = 0; k < d; ++k) {
      const int side = kPage * Brick<d>::extent(k), size = box.hi[k] - box.lo[k];
      box.lo[k] = side * int(std::floor(double(box.lo[k]) / side));
      if (random.below(2) == 0) box.lo[k] += side - 1 - size;
      box.hi[k] = box.lo[k] + size;
    }
  }
  const LatticePoint<d> centre = (box.lo + box.hi) / 2;
  const double radius = 0.6 * double(box.extent().maxCoeff());
  const RealPoint<d> slope = random_point<d>(random, 5).template cast<double>();
  const auto kind = random.below(8);
  description = std::array{"empty", "full", "single", "checkerboard", "noise", "ball", "half-space", "holes"}[kind];
  DigitalSet<d> set(box);
  const double density = random.uniform();
  for_each_point(box, [&](const LatticePoint<d>& z) {
    const RealPoint<d> p = (z - centre).template cast<double>();
    const std::array inside{false,
                            true,
                            z == centre,
                            (z.sum() & 1) == 0,
                            kind == 4 && random.uniform() < density,
                            p.norm() <= radius,
                            p.dot(slope) <= 0.3,
                            kind == 7 && random.below(100) != 0};
    if (inside[kind]) set.set(z, true);
  });
  return set;
}

template <int d>
RandomCase<d> random_case(std::uint64_t seed, int largest_radius, std::size_t most_spels) {
  RandomStream random({seed});
  std::string description;
  // Some sets hold whole balls, with bricks all around the ball's boundary.
  DigitalSet<d> set = random_digital_set<d>(random, 16 + (d == 2 ? 3 : 2) * largest_radius, description);
  std::vector<LatticePoint<d>> spels;
  const auto surfels = boundary(set);
  for (std::size_t i = 0; i < most_spels; ++i) {
    if (surfels.empty() || i % 8 == 0) {
      spels.push_back(random_point<d>(random, 150));
      continue;
    }
    const Surfel<d>& surfel = surfels[random.below(std::uint32_t(surfels.size()))];
    spels.push_back(random.below(2) == 0 ? surfel.inner : surfel.outer());
  }
  std::sort(spels.begin(), spels.end(), raster_less<d>);
  spels.erase(std::unique(spels.begin(), spels.end()), spels.end());
  const double radius = random_radius(random, largest_radius);
  const int half_axis = random.below(2) == 0 ? -1 : int(random.below(d));
  description += fmt::format(" in {}d, R/h = {}, half axis {}, seed {}", d, radius, half_axis, seed);
  return {std::move(set), {radius}, half_axis, std::move(spels), description};
}

/// Number of spels whose sums differ from those of the full kernel.
template <class Sum, int d>
int differences(const RandomCase<d>& one) {
  SpelsByBrick<d> spels;
  typename SpelsByBrick<d>::Memo memo;
  for (const LatticePoint<d>& z : one.spels) spels.insert(z, memo);
  spels.number();
  const std::vector<Sum> sums = BallSums<d, Sum>(one.radius, one.half_axis).eval(one.set, spels);
  const std::vector<Sum> expected =
      convolve<Sum>(Indicator<d>(one.set), ball_kernel<d>(one.radius, one.half_axis), nullptr, one.spels);
  int result = 0;
  for (std::size_t i = 0; i < one.spels.size(); ++i)
    result += !(sums[spels.position(one.spels[i], memo)] == expected[i]);
  return result;
}

}  // namespace gridstep::bricks
