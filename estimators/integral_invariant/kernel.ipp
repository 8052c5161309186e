#pragma once

#include <algorithm>
#include <cmath>

#include "shapes/base/contracts.hpp"

namespace gridstep {

template <int d, class Weight>
WeightedOffsets<d, Weight> group_by_weight(std::vector<std::pair<LatticePoint<d>, Weight>> entries) {
  std::erase_if(entries, [](const auto& entry) { return entry.second == Weight{}; });
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : raster_less<d>(a.first, b.first);
  });
  WeightedOffsets<d, Weight> result;
  result.offsets.reserve(entries.size());
  for (const auto& [offset, weight] : entries) {
    if (result.groups.empty() || result.groups.back().weight != weight)
      result.groups.push_back({weight, result.size(), result.size()});
    result.offsets.push_back(offset);
    result.groups.back().end = result.size();
  }
  return result;
}

template <int d, class WeightOf>
auto weighted_kernel(DigitalLength radius, WeightOf weight)
    -> Kernel<d, decltype(weight(LatticePoint<d>()))> {
  using Weight = decltype(weight(LatticePoint<d>()));
  std::vector<std::pair<LatticePoint<d>, Weight>> entries;
  for (const LatticePoint<d>& z : ball_kernel<d>(radius).offsets) entries.emplace_back(z, weight(z));
  return group_by_weight<d, Weight>(std::move(entries));
}

template <int d, class Weight>
const std::array<LatticePoint<d>, DisplacementMasks<d, Weight>::kCount>&
DisplacementMasks<d, Weight>::steps() {
  static const auto all = [] {
    std::array<LatticePoint<d>, kCount> result;
    std::size_t i = 0;
    for_each_point(LatticeBox<d>{LatticePoint<d>::Constant(-1), LatticePoint<d>::Constant(1)},
                   [&](const LatticePoint<d>& step) {
                     if (!step.isZero()) result[i++] = step;
                   });
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& a, const auto& b) { return a.cwiseAbs().sum() < b.cwiseAbs().sum(); });
    return result;
  }();
  return all;
}

template <int d, class Weight>
DisplacementMasks<d, Weight>::DisplacementMasks(const Kernel<d, Weight>& kernel) {
  // The kernel on a dense box with a margin of one, where g(p) and g(p + e) are looked up.
  LatticeBox<d> box{LatticePoint<d>::Zero(), LatticePoint<d>::Zero()};
  for (const LatticePoint<d>& z : kernel.offsets) box = {box.lo.cwiseMin(z), box.hi.cwiseMax(z)};
  box = box.dilated(2);
  const auto position = [&box, extent = box.extent()](const LatticePoint<d>& z) {
    std::size_t index = 0;
    for (int k = d - 1; k >= 0; --k) index = index * std::size_t(extent[k]) + std::size_t(z[k] - box.lo[k]);
    return index;
  };
  std::vector<Weight> g(std::size_t(box.volume()), Weight{});
  for (const auto& group : kernel.groups)
    for (std::size_t i = group.begin; i < group.end; ++i) g[position(kernel.offsets[i])] = group.weight;

  for (const LatticePoint<d>& step : steps()) {
    const std::ptrdiff_t ahead =
        std::ptrdiff_t(position(LatticePoint<d>(box.lo + step + LatticePoint<d>::Ones()))) -
        std::ptrdiff_t(position(LatticePoint<d>(box.lo + LatticePoint<d>::Ones())));
    std::vector<std::pair<LatticePoint<d>, Weight>> entries;
    for_each_point(box.dilated(-1), [&](const LatticePoint<d>& p) {
      const std::size_t at = position(p);
      const Weight delta = g[at] - g[std::size_t(std::ptrdiff_t(at) + ahead)];
      if (delta != Weight{}) entries.emplace_back(p, delta);
    });
    masks_[number(step)] = group_by_weight<d, Weight>(std::move(entries));
  }
}

}  // namespace gridstep
