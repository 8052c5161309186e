#include "estimators/surface/quad_surface.hpp"

#include <gtest/gtest.h>

#include <set>

#include "estimators/surface/ball_walk.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/surfel_corners.hpp"

namespace gridstep {
namespace {

const LatticePoint<3> kFar(20, 20, 20);

DigitalSet<3> noise(double density) {
  return random_set<3>({-kFar, kFar}, density, 41);
}

QuadSurface whole(const DigitalSet<3>& set) {
  return {set, boundary(set), {1}};
}

TEST(QuadSurface, IsAClosedOrientedMesh) {
  for (const double density : {0.1, 0.5, 0.9}) {
    const DigitalSet<3> set = noise(density);
    const QuadSurface surface = whole(set);
    ASSERT_EQ(surface.faces().size(), boundary(set).size());
    for (std::uint32_t f = 0; f < surface.faces().size(); ++f) {
      EXPECT_EQ(surface.number_of(surface.faces()[f]), f);
      const auto around = corners(surface.faces()[f]);
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t g = surface.neighbours(f)[i];
        ASSERT_NE(g, QuadSurface::kNone);
        // The neighbour has the same edge the other way round, with the same vertices, and f behind it.
        const auto of_g = corners(surface.faces()[g]);
        const auto at = std::size_t(std::find(of_g.begin(), of_g.end(), around[(i + 1) % 4]) - of_g.begin());
        ASSERT_LT(at, 4u);
        EXPECT_EQ(of_g[(at + 1) % 4], around[i]);
        EXPECT_EQ(surface.neighbours(g)[at], f);
        EXPECT_EQ(surface.vertices(g)[at], surface.vertices(f)[(i + 1) % 4]);
        EXPECT_EQ(surface.vertices(g)[(at + 1) % 4], surface.vertices(f)[i]);
      }
    }
  }
}

TEST(QuadSurface, OfABallIsASphere) {
  const DigitalSet<3> set = ball_set<3>(9.3);
  const QuadSurface surface = whole(set);
  const std::size_t faces = surface.faces().size();
  EXPECT_EQ(surface.vertex_count() - 2 * faces + faces, 2u) << "Euler's characteristic";
  std::vector<std::uint32_t> ring;
  for (std::uint32_t f = 0; f < faces; ++f)
    for (int i = 0; i < 4; ++i) {
      surface.ring(f, i, ring);
      EXPECT_GE(ring.size(), 3u);
      EXPECT_LE(ring.size(), 6u);
    }
}

TEST(QuadSurface, HasTheFacesWithinReach) {
  const DigitalSet<3> set = noise(0.4);
  const std::vector<Surfel<3>> all = boundary(set);
  const std::vector<Surfel<3>> some{all[all.size() / 3], all[all.size() / 3 + 1000]};
  const QuadSurface surface(set, some, {7});
  EXPECT_LT(surface.faces().size(), all.size());
  std::set<std::uint32_t> vertices;
  for (std::uint32_t f = 0; f < surface.faces().size(); ++f)
    vertices.insert(surface.vertices(f).begin(), surface.vertices(f).end());
  EXPECT_EQ(vertices.size(), surface.vertex_count());
  EXPECT_EQ(*vertices.rbegin() + 1, surface.vertex_count());
  for (const Surfel<3>& surfel : all)
    if ((surfel.inner - some[0].inner).cwiseAbs().maxCoeff() <= 7 ||
        (surfel.inner - some[1].inner).cwiseAbs().maxCoeff() <= 7) {
      EXPECT_NO_THROW((void)surface.number_of(surfel));
    }
  EXPECT_THROW((void)surface.number_of({kFar * 3, 0, 1}), ContractViolation);
}

/// By a plain flood over all faces whose cell meets the open ball.
std::set<std::uint32_t> flooded(const QuadSurface& surface, std::uint32_t start, double radius) {
  const LatticePoint<3> centre = surface.faces()[start].cell().coordinates;
  std::set<std::uint32_t> result;
  std::vector<std::uint32_t> todo{start};
  while (!todo.empty()) {
    const std::uint32_t f = todo.back();
    todo.pop_back();
    const auto around = corners(surface.faces()[f]);
    Eigen::Array3d lo = around[0].cast<double>(), hi = lo;
    for (const LatticePoint<3>& corner : around) {
      lo = lo.min(corner.cast<double>().array());
      hi = hi.max(corner.cast<double>().array());
    }
    const Eigen::Array3d nearest = centre.cast<double>().array().max(lo).min(hi);
    if ((nearest - centre.cast<double>().array()).matrix().norm() >= radius || !result.insert(f).second)
      continue;
    for (const std::uint32_t g : surface.neighbours(f)) todo.push_back(g);
  }
  return result;
}

TEST(BallWalk, VisitsWhatIsConnectedInTheBallOnce) {
  const DigitalSet<3> set = noise(0.35);
  const QuadSurface surface = whole(set);
  BallWalk walk(surface);
  for (std::uint32_t start = 0; start < surface.faces().size(); start += 997)
    for (const double radius : {0.4, 3.0, 7.7}) {
      std::vector<std::uint32_t> visited;
      walk(start, radius, [&](std::uint32_t face) { visited.push_back(face); });
      EXPECT_EQ(visited.front(), start);
      const std::set<std::uint32_t> once(visited.begin(), visited.end());
      EXPECT_EQ(once.size(), visited.size());
      EXPECT_EQ(once, flooded(surface, start, radius));
    }
}

TEST(BallWalk, MayNotLeaveTheSurface) {
  const DigitalSet<3> set = ball_set<3>(40);
  const Surfel<3> surfel = boundary(set)[0];
  const QuadSurface surface(set, {&surfel, 1}, {3});
  BallWalk walk(surface);
  EXPECT_NO_THROW(walk(surface.number_of(surfel), 4, [](std::uint32_t) {}));
  EXPECT_THROW(walk(surface.number_of(surfel), 100, [](std::uint32_t) {}), ContractViolation);
}

TEST(Inclusion, GoesFromTheNearestToTheFarthestCorner) {
  const LatticePoint<3> centre(0, 1, 1);             // a face orthogonal to x
  const Cell<3> next{{0, 3, 1}}, vertex{{0, 2, 2}};  // its neighbour, and one of its corners
  const double nearest = std::sqrt(2.0), farthest = std::sqrt(10.0);
  EXPECT_EQ(inclusion(next, centre, nearest), 0);
  EXPECT_EQ(inclusion(next, centre, farthest), 1);
  EXPECT_NEAR(inclusion(next, centre, 2), (2 - nearest) / (farthest - nearest), 1e-15);
  EXPECT_EQ(inclusion(Cell<3>{centre}, centre, 10), 1);
  EXPECT_NEAR(inclusion(Cell<3>{centre}, centre, 0.5), 0.5 / std::sqrt(2.0), 1e-15);
  EXPECT_EQ(inclusion(vertex, centre, nearest), 1) << "a vertex in the closed ball";
  EXPECT_EQ(inclusion(vertex, centre, 1.4), 0);
}

}  // namespace
}  // namespace gridstep
