#include "shapes/digital/boundary.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>

#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

template <int d>
struct Dimension {
  static constexpr int value = d;
};
template <class>
class Boundaries : public testing::Test {};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(Boundaries, Dimensions);

/// Points at random over a few pages, blocks of full and of holes among them; a full page.
template <int d>
DigitalSet<d> random_set(std::uint64_t seed) {
  RandomStream random{seed};
  const int reach = 20 + int(random.below(40));
  const LatticeBox<d> box{LatticePoint<d>::Constant(-reach), LatticePoint<d>::Constant(reach)};
  DigitalSet<d> set(box);
  if (random.below(2) == 0) set.fill_pages({set.page_box().lo, set.page_box().lo});
  const auto random_point = [&] {
    LatticePoint<d> z;
    for (int k = 0; k < d; ++k) z[k] = int(random.below(std::uint32_t(2 * reach))) - reach;
    return z;
  };
  for (int i = 0; i < 20; ++i) {
    const LatticePoint<d> corner = random_point();
    const bool value = random.below(3) != 0;
    for_each_point(set.domain().intersection({corner, corner.array() + int(random.below(20))}),
                   [&](const LatticePoint<d>& z) { set.set(z, value); });
  }
  for (int i = 0; i < 500; ++i) set.set(random_point(), random.below(2) == 0);
  return set;
}

/// The points of a box with coordinates of even sum: all surfels that the box can have.
template <int d>
DigitalSet<d> checkerboard(int reach) {
  const LatticeBox<d> box{LatticePoint<d>::Constant(-reach), LatticePoint<d>::Constant(reach)};
  DigitalSet<d> set(box);
  for_each_point(box, [&](const LatticePoint<d>& z) { set.set(z, z.sum() % 2 == 0); });
  return set;
}

/// The definition in its order: bricks as for_each_point_of() has them within pages, then axis, sign, and bit.
template <int d>
std::vector<Surfel<d>> plain_boundary(const DigitalSet<d>& set) {
  std::vector<Surfel<d>> surfels;
  for_each_point(set.page_box(), [&](const LatticePoint<d>& page) {
    const LatticePoint<d> first = page * DigitalSet<d>::kPageSide;
    for_each_point(LatticeBox<d>{first, first.array() + (DigitalSet<d>::kPageSide - 1)},
                   [&](const LatticePoint<d>& brick) {
                     if (set.state(brick) == DigitalSet<d>::kEmpty) return;
                     for (int axis = 0; axis < d; ++axis)
                       for (const int sign : {-1, +1})
                         for (int bit = 0; bit < Brick<d>::kBits; ++bit) {
                           const Surfel<d> surfel{Brick<d>::origin(brick) + Brick<d>::offset(bit),
                                                  std::int8_t(axis), std::int8_t(sign)};
                           if (set.contains(surfel.inner) && !set.contains(surfel.outer()))
                             surfels.push_back(surfel);
                         }
                   });
  });
  return surfels;
}

TYPED_TEST(Boundaries, HoldEverySurfelInOrderForEveryNumberOfThreads) {
  constexpr int d = TypeParam::value;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const DigitalSet<d> set = seed == 0 ? checkerboard<d>(20) : random_set<d>(seed);
    const std::vector<Surfel<d>> expected = plain_boundary(set);
    for (const int threads : {1, 2, 4})
      tbb::task_arena(threads).execute([&] { EXPECT_EQ(boundary(set), expected) << threads << " threads"; });
  }
  EXPECT_TRUE(boundary(DigitalSet<d>({LatticePoint<d>::Zero(), LatticePoint<d>::Zero()})).empty());
}

TYPED_TEST(Boundaries, ComeInChunksOfWholeBricks) {
  constexpr int d = TypeParam::value;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const DigitalSet<d> set = seed == 0 ? checkerboard<d>(20) : random_set<d>(seed);
    const std::vector<Surfel<d>> expected = boundary(set);
    for (const std::size_t most :
         {std::size_t{1}, std::size_t{100}, std::size_t{1536}, std::size_t{5000}, expected.size()})
      for (const int threads : {1, 2, 4})
        tbb::task_arena(threads).execute([&] {
          std::vector<Surfel<d>> all;
          for_each_boundary_chunk<d>(set, most, [&](std::span<const Surfel<d>> chunk) {
            ASSERT_FALSE(chunk.empty());
            const LatticePoint<d> first = Brick<d>::of(chunk.front().inner),
                                  last = Brick<d>::of(chunk.back().inner);
            EXPECT_LE(chunk.size(), first == last ? std::max<std::size_t>(most, 1536) : most);
            const bool new_brick = all.empty() || Brick<d>::of(all.back().inner) != first;
            EXPECT_TRUE(new_brick) << "a brick in two chunks";
            all.insert(all.end(), chunk.begin(), chunk.end());
          });
          EXPECT_EQ(all, expected) << threads << " threads, at most " << most;
        });
  }
}

template <int d>
struct InAnyOrder {
  bool operator()(const Surfel<d>& a, const Surfel<d>& b) const {
    if (a.inner != b.inner) return raster_less<d>(a.inner, b.inner);
    return a.axis != b.axis ? a.axis < b.axis : a.sign < b.sign;
  }
};

/// Components found one after the other by following adjacent surfels.
template <int d>
std::vector<std::vector<Surfel<d>>> plain_components(const DigitalSet<d>& set, SurfelAdjacency adjacency) {
  const std::vector<Surfel<d>> surfels = boundary(set);
  std::map<Surfel<d>, std::size_t, InAnyOrder<d>> component;
  std::vector<std::vector<Surfel<d>>> components;
  for (const Surfel<d>& start : surfels) {
    if (component.contains(start)) continue;
    std::vector<Surfel<d>> to_visit{start}, walk;
    while (!to_visit.empty()) {
      const Surfel<d> surfel = to_visit.back();
      to_visit.pop_back();
      if (!component.emplace(surfel, components.size()).second) continue;
      walk.push_back(surfel);
      for (int axis = 0; axis < d; ++axis)
        for (const int sign : {-1, +1}) {
          // In 2D only ahead, with the set on the left: the tangent is the normal turned by 90 degrees.
          if (axis == surfel.axis || (d == 2 && sign != (axis == 1 ? surfel.sign : -surfel.sign))) continue;
          to_visit.push_back(adjacent_surfel(set, surfel, axis, sign, adjacency));
        }
    }
    components.push_back(walk);
  }
  if (d == 3) {
    for (auto& walk : components) walk.clear();
    for (const Surfel<d>& surfel : surfels) components[component.at(surfel)].push_back(surfel);
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return components;
}

TYPED_TEST(Boundaries, AreSortedByComponents) {
  constexpr int d = TypeParam::value;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const DigitalSet<d> set = seed == 0 ? checkerboard<d>(8) : random_set<d>(seed);
    for (const SurfelAdjacency adjacency : {SurfelAdjacency::interior, SurfelAdjacency::exterior}) {
      const DigitalSurface<d> surface = connected_boundary(set, adjacency);
      const auto expected = plain_components(set, adjacency);
      ASSERT_EQ(surface.components(), expected.size());
      for (std::size_t c = 0; c < expected.size(); ++c) {
        const auto begin = surface.surfels.begin();
        EXPECT_EQ(std::vector(begin + std::ptrdiff_t(surface.component_begin[c]),
                              begin + std::ptrdiff_t(surface.component_begin[c + 1])),
                  expected[c]);
      }
    }
  }
  const DigitalSet<d> empty({LatticePoint<d>::Zero(), LatticePoint<d>::Zero()});
  EXPECT_EQ(connected_boundary(empty).components(), 0u);
}

/// Two points across an edge (in 2D, a corner) are two components, or one.
TYPED_TEST(Boundaries, AdjacencyDecidesWherePointsTouch) {
  constexpr int d = TypeParam::value;
  DigitalSet<d> set({LatticePoint<d>::Zero(), LatticePoint<d>::Ones()});
  LatticePoint<d> across = LatticePoint<d>::Zero();
  across[0] = across[1] = 1;
  set.set(LatticePoint<d>::Zero(), true);
  set.set(across, true);
  EXPECT_EQ(connected_boundary(set, SurfelAdjacency::interior).components(), 2u);
  EXPECT_EQ(connected_boundary(set, SurfelAdjacency::exterior).components(), 1u);
}

}  // namespace
}  // namespace gridstep
