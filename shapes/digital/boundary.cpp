#include "shapes/digital/boundary.hpp"

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <numeric>
#include <unordered_map>

#include "shapes/base/parallel.hpp"

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

/// Calls visit(axis, sign, bits) with the inner points of the surfels of a brick that face each way.
template <int d, class Visit>
void for_each_side(const DigitalSet<d>& set, const LatticePoint<d>& brick, Visit visit) {
  const std::int32_t state = set.state(brick);
  const Brick<d>& own = set.brick_of(state);
  for (int axis = 0; axis < d; ++axis)
    for (const int sign : {-1, +1}) {
      LatticePoint<d> next = brick;
      next[axis] += sign;
      const std::int32_t next_state = set.state(next);
      if (state == DigitalSet<d>::kFull && next_state == DigitalSet<d>::kFull) continue;
      Brick<d> bits = shifted(own, set.brick_of(next_state), axis, sign);
      for (std::size_t i = 0; i < 8; ++i) bits.words[i] = own.words[i] & ~bits.words[i];
      visit(axis, sign, bits);
    }
}

constexpr std::size_t kBricksAtOnce = 64;  // by one thread

/// How many surfels come before each brick, and then all of them.
template <int d>
std::vector<std::size_t> begin_of_bricks(const DigitalSet<d>& set, std::span<const LatticePoint<d>> bricks) {
  std::vector<std::size_t> begin(bricks.size() + 1, 0);
  parallel_chunks(bricks.size(), kBricksAtOnce, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i != last; ++i)
      for_each_side(set, bricks[i],
                    [&](int, int, const Brick<d>& bits) { begin[i + 1] += std::size_t(bits.count()); });
  });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  return begin;
}

/// Writes the surfels of some bricks, those of bricks[i] to out + begin[i] - begin[0].
template <int d>
void extract(const DigitalSet<d>& set, std::span<const LatticePoint<d>> bricks,
             std::span<const std::size_t> begin, Surfel<d>* out) {
  parallel_chunks(bricks.size(), kBricksAtOnce, [&](std::size_t first, std::size_t last) {
    Surfel<d>* next = out + (begin[first] - begin[0]);
    for (std::size_t i = first; i != last; ++i) {
      const LatticePoint<d> origin = Brick<d>::origin(bricks[i]);
      for_each_side(set, bricks[i], [&](int axis, int sign, const Brick<d>& bits) {
        for_each_bit(bits, [&](int bit) {
          *next++ = {origin + Brick<d>::offset(bit), std::int8_t(axis), std::int8_t(sign)};
        });
      });
    }
  });
}

template <int d>
std::vector<LatticePoint<d>> border_bricks(const DigitalSet<d>& set) {
  std::vector<LatticePoint<d>> bricks;
  for_each_border_brick(set, [&](const LatticePoint<d>& brick) { bricks.push_back(brick); });
  return bricks;
}

}  // namespace

template <int d>
std::vector<Surfel<d>> boundary(const DigitalSet<d>& set) {
  const std::vector<LatticePoint<d>> bricks = border_bricks(set);
  const std::vector<std::size_t> begin = begin_of_bricks<d>(set, bricks);
  std::vector<Surfel<d>> surfels(begin.back());
  extract<d>(set, bricks, begin, surfels.data());
  return surfels;
}

template <int d>
void for_each_boundary_chunk(const DigitalSet<d>& set, std::size_t most,
                             const std::function<void(std::span<const Surfel<d>>)>& visit) {
  constexpr std::size_t kBatch = 4096;  // bricks: work for all threads, some hundred kilobytes
  std::vector<LatticePoint<d>> batch;
  std::vector<Surfel<d>> chunk;
  const auto extract_batch = [&] {
    const std::vector<std::size_t> begin = begin_of_bricks<d>(set, batch);
    for (std::size_t first = 0, last; first < batch.size(); first = last) {
      last = first + 1;
      while (last < batch.size() && begin[last + 1] - begin[first] <= most) ++last;
      chunk.resize(begin[last] - begin[first]);
      extract<d>(set, std::span(batch).subspan(first, last - first), std::span(begin).subspan(first),
                 chunk.data());
      if (!chunk.empty()) visit(chunk);
    }
    batch.clear();
  };
  for_each_border_brick(set, [&](const LatticePoint<d>& brick) {
    batch.push_back(brick);
    if (batch.size() == kBatch) extract_batch();
  });
  extract_batch();
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
  template void for_each_boundary_chunk(const DigitalSet<d>&, std::size_t,                               \
                                        const std::function<void(std::span<const Surfel<d>>)>&);         \
  template Surfel<d> adjacent_surfel(const DigitalSet<d>&, const Surfel<d>&, int, int, SurfelAdjacency); \
  template DigitalSurface<d> connected_boundary(const DigitalSet<d>&, SurfelAdjacency);
GRIDSTEP_INSTANTIATE(2)
GRIDSTEP_INSTANTIATE(3)
#undef GRIDSTEP_INSTANTIATE

}  // namespace gridstep
