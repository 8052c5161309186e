#include "shapes/digital/kanungo_noise.hpp"

#include <cmath>
#include <vector>

#include "shapes/base/random.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {

template <int d>
DigitalSet<d> kanungo_noise(const DigitalSet<d>& set, double beta, std::uint64_t seed) {
  expects(beta >= 0 && beta < 1, "0 <= beta < 1");
  constexpr double kNegligible = 1e-9;
  const int depth = beta < kNegligible ? 0 : 1 + int(std::floor(std::log(kNegligible) / std::log(beta)));

  const LatticeBox<d> wide = set.domain().dilated(depth + 1);
  DigitalSet<d> noisy(wide), seen(wide);
  for_each_point(set.brick_box(), [&](const LatticePoint<d>& b) {
    if (set.state(b) != DigitalSet<d>::kEmpty) noisy.set_brick(b, set.brick(b));
  });

  // Layers of equal distance on both sides of the boundary; a path that crosses it is never the shortest.
  std::vector<LatticePoint<d>> layer, next;
  const auto visit = [&](std::vector<LatticePoint<d>>& points, const LatticePoint<d>& z) {
    if (seen.contains(z)) return;
    seen.set(z, true);
    points.push_back(z);
  };
  for (const Surfel<d>& surfel : boundary(set)) {
    visit(layer, surfel.inner);
    visit(layer, surfel.outer());
  }
  for (int distance = 0; distance < depth && !layer.empty(); ++distance) {
    const double probability = std::pow(beta, 1 + distance);
    next.clear();
    for (const LatticePoint<d>& z : layer) {
      RandomStream random{seed, std::uint64_t(z[0]), std::uint64_t(z[1]), std::uint64_t(z[d - 1])};
      if (random.uniform() < probability) noisy.set(z, !set.contains(z));
      for (int axis = 0; axis < d; ++axis)
        for (const int direction : {-1, +1}) {
          LatticePoint<d> neighbour = z;
          neighbour[axis] += direction;
          if (set.contains(neighbour) == set.contains(z)) visit(next, neighbour);
        }
    }
    layer.swap(next);
  }
  return noisy;
}

template DigitalSet<2> kanungo_noise(const DigitalSet<2>&, double, std::uint64_t);
template DigitalSet<3> kanungo_noise(const DigitalSet<3>&, double, std::uint64_t);

}  // namespace gridstep
