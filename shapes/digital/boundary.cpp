#include "shapes/digital/boundary.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

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
  const BrickNeighbours<d> neighbours(set, brick);
  const std::int32_t state = neighbours.state();
  const Brick<d>& own = set.brick_of(state);
  for (int axis = 0; axis < d; ++axis)
    for (const int sign : {-1, +1}) {
      const std::int32_t next_state = neighbours.next(axis, sign);
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

/// Finds the numbers of surfels in the boundary: the brick by bisection, unless it is that of the last surfel,
/// then the surfel.
template <int d>
class SurfelNumbers {
 public:
  /// Keeps references.
  SurfelNumbers(const std::vector<Surfel<d>>& surfels, const std::vector<LatticePoint<d>>& bricks,
                const std::vector<std::size_t>& begin)
      : surfels_(surfels), bricks_(bricks), begin_(begin) {}

  std::uint32_t operator()(const Surfel<d>& surfel) {
    const LatticePoint<d> brick = Brick<d>::of(surfel.inner);
    if (bricks_[last_] != brick)
      last_ = std::size_t(std::lower_bound(bricks_.begin(), bricks_.end(), brick, before) - bricks_.begin());
    const auto first = surfels_.begin() + std::ptrdiff_t(begin_[last_]);
    const auto behind = surfels_.begin() + std::ptrdiff_t(begin_[last_ + 1]);
    const auto found = std::ranges::lower_bound(first, behind, place(surfel), {}, place);
    return std::uint32_t(found - surfels_.begin());
  }

 private:
  static bool before(const LatticePoint<d>& a, const LatticePoint<d>& b) {
    const LatticePoint<d> page_of_a = DigitalSet<d>::page_of(a), page_of_b = DigitalSet<d>::page_of(b);
    return page_of_a != page_of_b ? raster_less<d>(page_of_a, page_of_b) : raster_less<d>(a, b);
  }
  /// In the order of its brick.
  static int place(const Surfel<d>& surfel) {
    return (2 * surfel.axis + (surfel.sign > 0)) * Brick<d>::kBits + Brick<d>::bit(surfel.inner);
  }

  const std::vector<Surfel<d>>& surfels_;
  const std::vector<LatticePoint<d>>& bricks_;
  const std::vector<std::size_t>& begin_;
  std::size_t last_ = 0;
};

/// Numbers of surfels, component after component.
struct Components {
  std::vector<std::uint32_t> order;
  std::vector<std::size_t> begin{0};
};

/// Each in the order of a walk from its first linel.
Components components_of(const DigitalSet<2>& set, const std::vector<Surfel<2>>& linels,
                         SurfelNumbers<2> number_of, SurfelAdjacency adjacency) {
  Components components;
  components.order.reserve(linels.size());
  std::vector<bool> seen(linels.size(), false);
  for (std::uint32_t start = 0; start < linels.size(); ++start) {
    if (seen[start]) continue;
    for (std::uint32_t i = start; !seen[i]; i = number_of(next_on_contour(set, linels[i], adjacency))) {
      seen[i] = true;
      components.order.push_back(i);
    }
    components.begin.push_back(components.order.size());
  }
  return components;
}

/// Each in the order of its numbers, by disjoint sets: trees whose roots are their least numbers.
Components components_of(const DigitalSet<3>& set, const std::vector<Surfel<3>>& surfels,
                         SurfelNumbers<3> number_of, SurfelAdjacency adjacency) {
  std::vector<std::uint32_t> parent(surfels.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::uint32_t i = 0; i < surfels.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      for (const int sign : {-1, +1}) {
        if (axis == surfels[i].axis) continue;
        const Surfel<3> next = adjacent_surfel(set, surfels[i], axis, sign, adjacency);
        if (next.axis == surfels[i].axis && sign < 0) continue;  // flat there: met from the other side
        const std::uint32_t a = root(i), b = root(number_of(next));
        parent[std::max(a, b)] = std::min(a, b);
      }

  // From parents to components in place: a parent comes before its children.
  std::vector<std::uint32_t>& component = parent;
  std::vector<std::size_t> size;
  for (std::uint32_t i = 0; i < surfels.size(); ++i) {
    const bool is_root = parent[i] == i;
    if (is_root) size.push_back(0);
    component[i] = is_root ? std::uint32_t(size.size() - 1) : component[parent[i]];
    ++size[component[i]];
  }
  Components components;
  components.begin.resize(size.size() + 1);
  std::partial_sum(size.begin(), size.end(), components.begin.begin() + 1);
  std::vector<std::size_t> next(components.begin);
  components.order.resize(surfels.size());
  for (std::uint32_t i = 0; i < surfels.size(); ++i) components.order[next[component[i]]++] = i;
  return components;
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
std::size_t boundary_size(const DigitalSet<d>& set) {
  return begin_of_bricks<d>(set, border_bricks(set)).back();
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
  const std::vector<LatticePoint<d>> bricks = border_bricks(set);
  const std::vector<std::size_t> begin = begin_of_bricks<d>(set, bricks);
  expects(begin.back() <= std::numeric_limits<std::uint32_t>::max(), "fewer than 2^32 surfels");
  std::vector<Surfel<d>> surfels(begin.back());
  extract<d>(set, bricks, begin, surfels.data());

  const Components components =
      components_of(set, surfels, SurfelNumbers<d>(surfels, bricks, begin), adjacency);
  const auto size = [&](std::size_t c) { return components.begin[c + 1] - components.begin[c]; };
  std::vector<std::size_t> larger_first(components.begin.size() - 1);
  std::iota(larger_first.begin(), larger_first.end(), std::size_t{0});
  std::ranges::stable_sort(larger_first, std::greater(), size);

  DigitalSurface<d> surface;
  surface.surfels.reserve(surfels.size());
  surface.component_begin.push_back(0);
  for (const std::size_t c : larger_first) {
    for (std::size_t i = components.begin[c]; i != components.begin[c + 1]; ++i)
      surface.surfels.push_back(surfels[components.order[i]]);
    surface.component_begin.push_back(surface.surfels.size());
  }
  return surface;
}

#define GRIDSTEP_INSTANTIATE(d)                                                                          \
  template std::vector<Surfel<d>> boundary(const DigitalSet<d>&);                                        \
  template std::size_t boundary_size(const DigitalSet<d>&);                                              \
  template void for_each_boundary_chunk(const DigitalSet<d>&, std::size_t,                               \
                                        const std::function<void(std::span<const Surfel<d>>)>&);         \
  template Surfel<d> adjacent_surfel(const DigitalSet<d>&, const Surfel<d>&, int, int, SurfelAdjacency); \
  template DigitalSurface<d> connected_boundary(const DigitalSet<d>&, SurfelAdjacency);
GRIDSTEP_INSTANTIATE(2)
GRIDSTEP_INSTANTIATE(3)
#undef GRIDSTEP_INSTANTIATE

}  // namespace gridstep
