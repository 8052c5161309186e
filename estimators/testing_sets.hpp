#pragma once

// Digital sets for the tests of this folder.

#include "shapes/base/random.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// Each point of the box with the given probability. The domain is larger: whole pages.
template <int d>
DigitalSet<d> random_set(const LatticeBox<d>& box, double density, std::uint64_t seed) {
  RandomStream random({seed});
  DigitalSet<d> set(box);
  for_each_point(box, [&](const LatticePoint<d>& z) {
    if (random.uniform() < density) set.set(z, true);
  });
  return set;
}

/// The points z of the box with inside(z).
template <int d, class Inside>
DigitalSet<d> set_where(const LatticeBox<d>& box, Inside inside) {
  DigitalSet<d> set(box);
  for_each_point(box, [&](const LatticePoint<d>& z) {
    if (inside(z)) set.set(z, true);
  });
  return set;
}

/// {z : |z - c| <= r}, in a domain with some margin.
template <int d>
DigitalSet<d> ball_set(double r, const LatticePoint<d>& c = LatticePoint<d>::Zero()) {
  const int reach = int(r) + 1;
  return set_where<d>({c.array() - reach, c.array() + reach}, [&](const LatticePoint<d>& z) {
    return (z - c).template cast<double>().squaredNorm() <= r * r;
  });
}

/// The least-squares slope of log(y) over log(x).
inline double log_log_slope(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = Eigen::Index(x.size());
  const Eigen::ArrayXd u = Eigen::Map<const Eigen::ArrayXd>(x.data(), n).log();
  const Eigen::ArrayXd v = Eigen::Map<const Eigen::ArrayXd>(y.data(), n).log();
  return ((u - u.mean()) * (v - v.mean())).sum() / (u - u.mean()).square().sum();
}

}  // namespace gridstep
