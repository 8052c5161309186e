#include "estimators/integral_invariant/radial/weight_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimators/integral_invariant/kernel.hpp"

namespace gridstep {

WeightTables::WeightTables(const RadialWeights& weights, DigitalLength radius, int half_axis)
    : half_axis_(half_axis),
      reach_(int(std::ceil(radius.value)) + 1),
      most_((reach_ + 7) / 8),
      limit_(squared_diameter(radius)),
      side_(2 * margin() + 1) {
  std::array<std::vector<std::int64_t>, 3> squares;
  for (int k = 0; k < 3; ++k) {
    for (int p = -margin(); p <= margin(); ++p) {
      const std::int64_t x = 2 * std::int64_t{p} - (k == half_axis);
      squares[std::size_t(k)].push_back(x * x);
    }
    for (auto first = squares[std::size_t(k)].begin(); first + 8 <= squares[std::size_t(k)].end(); ++first)
      nearest_[std::size_t(k)].push_back(*std::min_element(first, first + 8));
  }
  weights_.assign(std::size_t(3 * side_ * side_ * side_), 0);
  std::int32_t* line = weights_.data();
  for (std::ptrdiff_t z = 0; z < side_; ++z)
    for (std::ptrdiff_t y = 0; y < side_; ++y, line += 3 * side_)
      for (std::ptrdiff_t x = 0; x < side_; ++x) {
        const std::int64_t squared =
            squares[0][std::size_t(x)] + squares[1][std::size_t(y)] + squares[2][std::size_t(z)];
        if (squared > limit_) continue;
        line[x] = std::int32_t(weights.trace(squared));
        line[side_ + x] = std::int32_t(weights.edge(squared));
        line[2 * side_ + x] = std::int32_t(weights.tensor(squared));
      }
}

}  // namespace gridstep
