#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/base/placement.hpp"
#include "shapes/base/random.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

/// For tests over every line of the catalogue.
inline std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const ShapeEntry& entry : shape_catalogue()) names.push_back(entry.name);
  return names;
}

inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// The length by which grid steps and samples are chosen: the size, but for the spikes of distel, which reach
/// 100 and are thinner than any cell beyond 3.
template <int d>
double feature(const Shape<d>& shape) {
  return shape.size() > 100 ? 3.0 : shape.size();
}

template <int d>
RealPoint<d> random_point(const RealBox<d>& box, RandomStream& random) {
  RealPoint<d> p;
  for (int k = 0; k < d; ++k) p[k] = box.min()[k] + random.uniform() * box.sizes()[k];
  return p;
}

template <int d>
SceneSettings<d> random_settings(double h, std::uint64_t seed) {
  RandomStream random{seed};
  SceneSettings<d> settings;
  settings.h = {h};
  settings.placement.shift = random_shift<d>(random);
  settings.placement.rotation = random_rotation<d>(random);
  return settings;
}

}  // namespace gridstep
