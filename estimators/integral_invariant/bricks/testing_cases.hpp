#pragma once

// Random cases for comparing the ways to evaluate: by the hundred in every test run, by the million on demand.

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

struct RandomBall {
  DigitalLength radius;
  int half_axis;  ///< see ball_kernel()
};

template <int d>
struct RandomSet {
  DigitalSet<d> set;
  std::vector<LatticePoint<d>> spels;  ///< distinct, in raster order; most at the boundary
  std::string kind;
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

template <int d>
RandomBall random_ball(RandomStream& random, int largest_radius) {
  const double radius = random_radius(random, largest_radius);
  return {{radius}, random.below(2) == 0 ? -1 : int(random.below(d))};
}

/// In a box of random place and size, which in one case in four fills its domain to the border.
template <int d>
RandomSet<d> random_set(RandomStream& random, int largest_side, std::size_t most_spels) {
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
  const std::array kinds{"empty", "full", "single", "checkerboard", "noise", "ball", "half-space", "holes"};
  const auto kind = random.below(kinds.size());
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
  return {std::move(set), std::move(spels), kinds[kind]};
}

/// By the target in use.
template <class Sum, int d>
std::vector<Sum> brick_sums(const BallSums<d, Sum>& balls, const RandomSet<d>& one) {
  SpelsByBrick<d> spels;
  typename SpelsByBrick<d>::Memo memo;
  for (const LatticePoint<d>& z : one.spels) spels.insert(z, memo);
  spels.number();
  const auto sums = balls.eval(one.set, spels);
  std::vector<Sum> result;
  for (const LatticePoint<d>& z : one.spels) result.push_back(sums[spels.position(z, memo)]);
  return result;
}

/// The sums over one ball at the spels of a set, in every way.
template <class Sum, int d>
class Evaluations {
 public:
  explicit Evaluations(const RandomBall& ball)
      : kernel_(ball_kernel<d>(ball.radius, ball.half_axis)), masks_(kernel_), balls_(ball.radius, ball.half_axis) {}

  std::vector<Sum> full(const RandomSet<d>& one) const {
    return convolve<Sum>(Indicator<d>(one.set), kernel_, nullptr, one.spels);
  }
  std::vector<Sum> masks(const RandomSet<d>& one) const {
    return convolve<Sum>(Indicator<d>(one.set), kernel_, &masks_, one.spels);
  }
  std::vector<Sum> bricks(const RandomSet<d>& one) const { return brick_sums(balls_, one); }

 private:
  Kernel<d, std::int64_t> kernel_;
  DisplacementMasks<d, std::int64_t> masks_;
  BallSums<d, Sum> balls_;
};

}  // namespace gridstep::bricks
