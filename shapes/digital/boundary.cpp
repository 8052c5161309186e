#include "shapes/digital/boundary.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <numeric>
#include <unordered_map>

namespace gridstep {

namespace {

template <int d>
struct SurfelHash {
  std::size_t operator()(const Surfel<d>& surfel) const {
    std::uint64_t hash = std::uint64_t(2 * surfel.axis + (surfel.sign > 0));
    for (int k = 0; k < d; ++k) hash = (hash ^ std::uint32_t(surfel.inner[k])) * 0x9e3779b97f4a7c15ULL;
    return hash ^ (hash >> 29);
  }
};

/// The linel that begins where this one ends, the set being on the left: the walk turns the outward normal by
/// -90 degrees to get its direction.
Surfel<2> next_on_contour(const DigitalSet<2>& set, const Surfel<2>& linel, SurfelAdjacency adjacency) {
  // Normal (nx, ny) has tangent (-ny, nx): counterclockwise around the set.
  const int axis = 1 - linel.axis;
  const int sign = linel.axis == 0 ? linel.sign : -linel.sign;
  return adjacent_surfel(set, linel, axis, sign, adjacency);
}

}  // namespace

template <int d>
std::vector<Surfel<d>> boundary(const DigitalSet<d>& set) {
  std::vector<Surfel<d>> surfels;
  for_each_border_brick(set, [&](const LatticePoint<d>& b) {
    const Brick<d> own = set.brick(b);
    const LatticePoint<d> origin = Brick<d>::origin(b);
    for (int axis = 0; axis < d; ++axis)
      for (const int sign : {-1, +1}) {
        LatticePoint<d> next = b;
        next[axis] += sign;
        Brick<d> border = shifted(own, set.brick(next), axis, sign);
        for (int i = 0; i < 8; ++i) border.words[i] = own.words[i] & ~border.words[i];
        for_each_bit(border, [&](int bit) {
          surfels.push_back({origin + Brick<d>::offset(bit), std::int8_t(axis), std::int8_t(sign)});
        });
      }
  });
  return surfels;
}

template <int d>
Surfel<d> adjacent_surfel(const DigitalSet<d>& set, const Surfel<d>& surfel, int axis, int sign,
                          SurfelAdjacency adjacency) {
  LatticePoint<d> inner_next = surfel.inner, outer_next = surfel.outer();
  inner_next[axis] += sign;
  outer_next[axis] += sign;
  const bool inner_continues = set.contains(inner_next), outer_continues = !set.contains(outer_next);
  const Surfel<d> convex{surfel.inner, std::int8_t(axis), std::int8_t(sign)};
  const Surfel<d> flat{inner_next, surfel.axis, surfel.sign};
  const Surfel<d> concave{outer_next, std::int8_t(axis), std::int8_t(-sign)};
  if (inner_continues) return outer_continues ? flat : concave;
  if (outer_continues) return convex;
  return adjacency == SurfelAdjacency::interior ? convex : concave;
}

template <int d>
DigitalSurface<d> connected_boundary(const DigitalSet<d>& set, SurfelAdjacency adjacency) {
  std::vector<Surfel<d>> surfels = boundary(set);
  std::unordered_map<Surfel<d>, std::size_t, SurfelHash<d>> index;
  index.reserve(surfels.size());
  for (std::size_t i = 0; i < surfels.size(); ++i) index.emplace(surfels[i], i);

  // Components as lists of surfel numbers, each in its final order.
  std::vector<std::vector<std::size_t>> components;
  if constexpr (d == 2) {
    std::vector<bool> seen(surfels.size(), false);
    for (std::size_t start = 0; start < surfels.size(); ++start) {
      if (seen[start]) continue;
      components.emplace_back();
      for (std::size_t i = start; !seen[i]; i = index.at(next_on_contour(set, surfels[i], adjacency))) {
        seen[i] = true;
        components.back().push_back(i);
      }
    }
  } else {
    std::vector<std::size_t> rank(surfels.size(), 0), parent(surfels.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    for (std::size_t i = 0; i < surfels.size(); ++i)
      for (int axis = 0; axis < d; ++axis)
        if (axis != surfels[i].axis)
          for (const int sign : {-1, +1})
            sets.union_set(i, index.at(adjacent_surfel(set, surfels[i], axis, sign, adjacency)));
    std::unordered_map<std::size_t, std::size_t> component_of;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
      const auto [found, is_new] = component_of.emplace(sets.find_set(i), components.size());
      if (is_new) components.emplace_back();
      components[found->second].push_back(i);
    }
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });

  DigitalSurface<d> surface;
  surface.surfels.reserve(surfels.size());
  surface.component_begin.push_back(0);
  for (const std::vector<std::size_t>& component : components) {
    for (const std::size_t i : component) surface.surfels.push_back(surfels[i]);
    surface.component_begin.push_back(surface.surfels.size());
  }
  return surface;
}

#define GRIDSTEP_INSTANTIATE(d)                                                                          \
  template std::vector<Surfel<d>> boundary(const DigitalSet<d>&);                                        \
  template Surfel<d> adjacent_surfel(const DigitalSet<d>&, const Surfel<d>&, int, int, SurfelAdjacency); \
  template DigitalSurface<d> connected_boundary(const DigitalSet<d>&, SurfelAdjacency);
GRIDSTEP_INSTANTIATE(2)
GRIDSTEP_INSTANTIATE(3)
#undef GRIDSTEP_INSTANTIATE

}  // namespace gridstep
