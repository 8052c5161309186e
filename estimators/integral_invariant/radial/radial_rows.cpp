#include "estimators/integral_invariant/radial/radial_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "estimators/integral_invariant/kernel.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

RadialRows::RadialRows(const RadialWeights& weights, DigitalLength radius, int half_axis) {
  const std::int64_t limit = squared_diameter(radius);
  if (radius.value > kGreatestRadius)
    throw InputError(
        fmt::format("kernel radius R/h = {:.6g}: the tables of radial kernels are made for {} cells at most",
                    radius.value, kGreatestRadius));
  reach_ = int(std::ceil(radius.value)) + 1;
  const auto squared = [](int p, bool half) {
    const std::int64_t x = 2 * std::int64_t{p} - half;
    return x * x;
  };
  for (int y = -reach_; y <= reach_; ++y) {
    Prefix sum{0, 0};
    half_width_.push_back(-1);
    for (int x = -reach_; x <= reach_; ++x) {
      prefix_.push_back(sum);
      const std::int64_t distance = squared(x, half_axis == 0) + squared(y, half_axis == 1);
      if (distance > limit) continue;
      half_width_.back() = std::max(half_width_.back(), std::abs(x));
      sum.trace += weights.trace(distance);
      sum.edge += weights.edge(distance);
    }
    prefix_.push_back(sum);
  }
}

std::vector<RadialSum> RadialRows::eval(const RowRuns& rows, std::span<const LatticePoint<2>> points,
                                        EvaluationWork* work) const {
  std::vector<RadialSum> result(points.size());
  PerWorker<std::int64_t> visited;
  constexpr std::size_t kGrain = 64;
  parallel_chunks(points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::int64_t& runs = visited.local();
    for (std::size_t i = begin; i != end; ++i)
      for (int y = -reach_; y <= reach_; ++y) {
        const int width = half_width_[std::size_t(y + reach_)];
        if (width < 0) continue;
        const int x = points[i][0];
        const Prefix* const row =
            &prefix_[std::size_t(y + reach_) * std::size_t(2 * reach_ + 2) + std::size_t(reach_)];
        rows.for_each_run(points[i][1] + y, x - width, x + width, [&](int first, int last) {
          result[i].trace += row[last + 1 - x].trace - row[first - x].trace;
          result[i].edge += row[last + 1 - x].edge - row[first - x].edge;
          ++runs;
        });
      }
  });
  if (work) {
    work->points += std::int64_t(points.size());
    visited.for_each([&](const std::int64_t& runs) { work->cells_visited += runs; });
  }
  return result;
}

}  // namespace gridstep
