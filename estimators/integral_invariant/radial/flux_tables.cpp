#include "estimators/integral_invariant/radial/flux_tables.hpp"

#include <cmath>

#include "estimators/integral_invariant/kernel.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

/// The weights of a point, times its coordinates x from the centre where a component is so.
template <class Flux>
Flux weighted(const RadialWeights& weights, const LatticePoint<3>& p, int half_axis, std::int64_t limit) {
  const auto coordinate = [&](int k) { return 2 * std::int64_t{p[k]} - (k == half_axis); };
  const std::array<std::int64_t, 3> x{coordinate(0), coordinate(1), coordinate(2)};
  const std::int64_t squared = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  Flux flux;
  if (squared > limit) return flux;
  auto& [of] = flux;
  of[0] = weights.trace(squared);
  of[1] = weights.edge(squared);
  if constexpr (std::is_same_v<Flux, WholeFlux>) {
    const std::int64_t tensor = weights.tensor(squared);
    for (std::size_t i = 0, pair = 5; i < 3; ++i) {
      of[2 + i] = of[1] * x[i];
      for (std::size_t j = i; j < 3; ++j, ++pair) of[pair] = tensor * x[i] * x[j];
    }
  }
  return flux;
}

}  // namespace

template <class Flux>
FluxTables<Flux>::FluxTables(const RadialWeights& weights, DigitalLength radius, int half_axis)
    : reach_(int(std::ceil(radius.value)) + 1),
      most_((reach_ + 7) / 8),
      stride_(2 * margin() + 1),
      stride_z_((2 * reach_ + 1) * stride_),
      lines_(std::size_t(2 * reach_ + 1)),
      along_x_(std::size_t((2 * reach_ + 1) * stride_z_)),
      along_y_(std::size_t((2 * reach_ + 1) * stride_)) {
  const std::int64_t limit = squared_diameter(radius);
  parallel_chunks(lines_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row != end; ++row) {
      LatticePoint<3> p(0, 0, int(row) - reach_);
      Flux* const face = &along_y_[row * std::size_t(stride_)];
      Flux above;
      for (int y = margin(); y >= -margin(); --y) {
        p[1] = y;
        if (std::abs(y) <= reach_) {
          Flux* const line = &along_x_[row * std::size_t(stride_z_) + std::size_t((y + reach_) * stride_)];
          Flux sum;
          for (int x = margin(); x >= -margin(); --x) {
            p[0] = x;
            sum += weighted<Flux>(weights, p, half_axis, limit);
            line[x + margin()] = sum;
          }
          above += sum;
          p[0] = 0;
          const std::int64_t dy = 2 * y - (half_axis == 1), dz = 2 * p[2] - (half_axis == 2);
          if (dy * dy + dz * dz + (half_axis == 0) <= limit) {
            auto& [low, high] = lines_[row];
            high = high < low ? y : high;
            low = y;
          }
        }
        face[y + margin()] = above;
      }
    }
  });
}

template class FluxTables<CurvatureFlux>;
template class FluxTables<WholeFlux>;

}  // namespace gridstep
