#include "shapes/digital/khalimsky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

template <int d>
struct Dimension {
  static constexpr int value = d;
};
template <class>
class Khalimsky : public testing::Test {};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(Khalimsky, Dimensions);

/// Calls check(cell) for cells of every kind, on both sides of 0.
template <int d, class Check>
void for_cells(Check check) {
  for_each_point(LatticeBox<d>{LatticePoint<d>::Constant(-3), LatticePoint<d>::Constant(3)},
                 [&](const LatticePoint<d>& coordinates) { check(Cell<d>{coordinates}); });
}

template <int d>
bool in_closure(const Cell<d>& face, const Cell<d>& cell) {
  for (int k = 0; k < d; ++k) {
    const int difference = std::abs(face.coordinates[k] - cell.coordinates[k]);
    if (difference > (cell.open(k) ? 1 : 0)) return false;
  }
  return true;
}

/// Signed cells summed as a chain; cells whose signs cancel are left out.
template <int d>
std::map<std::vector<int>, int> chain(const std::vector<SignedCell<d>>& cells) {
  std::map<std::vector<int>, int> sum;
  for (const SignedCell<d>& s : cells) {
    const std::vector<int> key(s.cell.coordinates.data(), s.cell.coordinates.data() + d);
    if ((sum[key] += s.sign) == 0) sum.erase(key);
  }
  return sum;
}

TYPED_TEST(Khalimsky, SpelsAndPointelsHaveTheirCoordinates) {
  constexpr int d = TypeParam::value;
  for_each_point(LatticeBox<d>{LatticePoint<d>::Constant(-5), LatticePoint<d>::Constant(5)},
                 [&](const LatticePoint<d>& z) {
                   EXPECT_EQ(spel<d>(z).coordinates, (2 * z.array() + 1).matrix());
                   EXPECT_EQ(spel<d>(z).dimension(), d);
                   EXPECT_EQ(pointel<d>(z).dimension(), 0);
                   EXPECT_EQ(digital_point(spel<d>(z)), z);
                   EXPECT_EQ(digital_point(pointel<d>(z)), z);
                   EXPECT_EQ(centre(spel<d>(z), 0.25), 0.25 * z.template cast<double>());
                   EXPECT_EQ(centre(pointel<d>(z), 1.0), (z.template cast<double>().array() - 0.5).matrix());
                 });
}

TYPED_TEST(Khalimsky, ACellHasAllTheFacesOfItsClosure) {
  constexpr int d = TypeParam::value;
  for_cells<d>([](const Cell<d>& cell) {
    const int dimension = cell.dimension();
    EXPECT_EQ(faces(cell).size(), std::size_t(std::lround(std::pow(3, dimension))) - 1);
    EXPECT_EQ(cofaces(cell).size(), std::size_t(std::lround(std::pow(3, d - dimension))) - 1);
    EXPECT_EQ(direct_faces(cell).size(), std::size_t(2 * dimension));
    EXPECT_EQ(direct_cofaces(cell).size(), std::size_t(2 * (d - dimension)));
    for (const Cell<d>& face : faces(cell)) {
      EXPECT_LT(face.dimension(), dimension);
      EXPECT_TRUE(in_closure(face, cell));
      const auto back = cofaces(face);
      EXPECT_EQ(std::count(back.begin(), back.end(), cell), 1) << "a face without its coface";
    }
    for (const Cell<d>& coface : cofaces(cell)) EXPECT_TRUE(in_closure(cell, coface));
    for (const Cell<d>& face : direct_faces(cell)) EXPECT_EQ(face.dimension(), dimension - 1);
    for (const Cell<d>& coface : direct_cofaces(cell)) EXPECT_EQ(coface.dimension(), dimension + 1);
  });
}

TYPED_TEST(Khalimsky, TheBoundaryOfABoundaryVanishes) {
  constexpr int d = TypeParam::value;
  for_cells<d>([](const Cell<d>& cell) {
    for (const int sign : {-1, +1}) {
      const auto faces_of_cell = boundary(SignedCell<d>{cell, sign});
      EXPECT_EQ(faces_of_cell.size(), direct_faces(cell).size());
      std::vector<SignedCell<d>> twice;
      for (const SignedCell<d>& face : faces_of_cell)
        for (const SignedCell<d>& edge : boundary(face)) twice.push_back(edge);
      EXPECT_TRUE(chain(twice).empty());
    }
  });
}

TYPED_TEST(Khalimsky, AFaceHasOppositeSignsInItsTwoSpels) {
  constexpr int d = TypeParam::value;
  const Cell<d> cell = spel<d>(LatticePoint<d>::Constant(-2));
  for (int axis = 0; axis < d; ++axis) {
    const SignedCell<d> upper = signed_incident<d>({cell, +1}, axis, +1);
    const SignedCell<d> lower = signed_incident<d>({adjacent(cell, axis, +1), +1}, axis, -1);
    EXPECT_EQ(upper, lower.opposite());
    // (-1)^(open directions before the axis): +, -, + in a spel.
    EXPECT_EQ(upper.sign, axis % 2 == 0 ? 1 : -1);
    EXPECT_EQ(signed_incident<d>({cell, -1}, axis, +1), upper.opposite());
  }
}

TYPED_TEST(Khalimsky, ASurfelLiesHalfWayBetweenItsSpels) {
  constexpr int d = TypeParam::value;
  LatticePoint<d> inner = LatticePoint<d>::Constant(-4);
  inner[1] = 7;
  for (int axis = 0; axis < d; ++axis)
    for (const int sign : {-1, +1}) {
      const Surfel<d> surfel{inner, std::int8_t(axis), std::int8_t(sign)};
      EXPECT_EQ(surfel.outer() - inner, sign * LatticePoint<d>::Unit(axis));
      EXPECT_EQ(surfel.cell().dimension(), d - 1);
      EXPECT_FALSE(surfel.cell().open(axis));
      EXPECT_EQ(surfel.signed_cell().cell, surfel.cell());
      EXPECT_EQ(surfel.cell().coordinates, spel<d>(inner).coordinates + sign * LatticePoint<d>::Unit(axis));
      const RealPoint<d> middle =
          0.125 * (inner.template cast<double>() + surfel.outer().template cast<double>()) / 2;
      EXPECT_EQ(centre(surfel, 0.125), middle);
      EXPECT_EQ(surfel.normal(), (surfel.outer() - inner).template cast<double>());
      // Seen from the other side, the same cell with the other sign.
      const Surfel<d> opposite{surfel.outer(), std::int8_t(axis), std::int8_t(-sign)};
      EXPECT_EQ(opposite.signed_cell(), surfel.signed_cell().opposite());
    }
}

TYPED_TEST(Khalimsky, AdjacencyCountsNeighbours) {
  constexpr int d = TypeParam::value;
  std::array<int, d> neighbours{};
  const LatticePoint<d> z = LatticePoint<d>::Constant(-1);
  for_each_point(LatticeBox<d>{LatticePoint<d>::Constant(-4), LatticePoint<d>::Constant(2)},
                 [&](const LatticePoint<d>& other) {
                   for (int r = 0; r < d; ++r) neighbours[r] += adjacent_spels<d>(z, other, r);
                 });
  if constexpr (d == 2)
    EXPECT_EQ(neighbours, (std::array{8, 4}));
  else
    EXPECT_EQ(neighbours, (std::array{26, 18, 6}));
}

}  // namespace
}  // namespace gridstep
