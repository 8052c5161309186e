#include "estimators/integral_invariant/radial/flux_tables.hpp"

#include <cmath>

#include "estimators/integral_invariant/kernel.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

template <class Flux>
FluxTables<Flux>::FluxTables(const RadialWeights& weights, DigitalLength radius, int half_axis)
    : half_axis_(half_axis),
      reach_(int(std::ceil(radius.value)) + 1),
      most_((reach_ + 7) / 8),
      strides_{2 * reach_ + 1, 1, (2 * reach_ + 1) * (2 * margin() + 1)},
      lines_(std::size_t(2 * reach_ + 1)),
      along_x_(lines_.size() * std::size_t(strides_[2])),
      along_y_(lines_.size() * std::size_t(face_stride())) {
  const std::int64_t limit = squared_diameter(radius);
  const auto coordinate = [&](int k, int p) { return 2 * std::int64_t{p} - (k == half_axis); };
  parallel_chunks(lines_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row != end; ++row) {
      const int z = int(row) - reach_;
      const std::int64_t Z = coordinate(2, z);
      auto* const face = &along_y_[row * std::size_t(face_stride())];
      typename Flux::Sum above;
      for (int y = margin(); y >= -margin(); --y) {
        if (std::abs(y) <= reach_) {
          const std::int64_t Y = coordinate(1, y);
          Flux sum;
          bool reached = false;
          for (int x = margin(); x >= -margin(); --x) {
            const std::int64_t X = coordinate(0, x), squared = X * X + Y * Y + Z * Z;
            if (squared <= limit) {
              sum += Flux::of(weights(squared), X);
              reached = true;
            }
            along_x_[entry(x, y, z)] = sum;
          }
          typename Flux::Slice slice;
          slice.template add<1>(sum, Y);
          above += slice.at(Z);
          if (reached) {
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
