#include "estimators/contour/digital_contour.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {
namespace {

double signed_area(const DigitalContour& contour) {
  double twice = 0;
  for (std::ptrdiff_t i = 0; i < contour.size(); ++i)
    twice += double(contour[i][0]) * contour[i + 1][1] - double(contour[i][1]) * contour[i + 1][0];
  return twice / 2;
}

DigitalSet<2> random_cells(std::uint64_t seed) {
  return random_set<2>({LatticePoint<2>{-6, -5}, LatticePoint<2>{7, 9}}, 0.5, seed);
}

TEST(DigitalContour, TurnsAroundOneCellWithItOnTheLeft) {
  DigitalSet<2> set({LatticePoint<2>{-2, -2}, LatticePoint<2>{5, 5}});
  set.set({3, -1}, true);
  const auto contours = closed_contours(connected_boundary(set).surfels);
  ASSERT_EQ(contours.size(), 1u);
  ASSERT_EQ(contours[0].size(), 4);
  EXPECT_EQ(signed_area(contours[0]), 1);
  for (const LatticePoint<2>& corner : contours[0].pointels) {
    EXPECT_TRUE(corner[0] == 3 || corner[0] == 4);
    EXPECT_TRUE(corner[1] == -1 || corner[1] == 0);
  }
}

TEST(DigitalContour, EndsAreTheFacesOfTheLinel) {
  for (const Surfel<2>& linel : boundary(random_cells(3))) {
    auto ends = direct_faces(linel.cell());
    const auto is_end = [&](const LatticePoint<2>& p) {
      return std::count(ends.begin(), ends.end(), pointel<2>(p)) == 1;
    };
    EXPECT_TRUE(is_end(start_pointel(linel)) && is_end(end_pointel(linel)));
    // The outward normal is on the right of the step.
    const LatticePoint<2> step = end_pointel(linel) - start_pointel(linel);
    EXPECT_EQ(linel.normal()[0], step[1]);
    EXPECT_EQ(linel.normal()[1], -step[0]);
  }
}

// Random sets have many contours that touch themselves and each other.
TEST(DigitalContour, SplitsARangeAsTheBoundaryDoes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const DigitalSet<2> set = random_cells(seed);
    const DigitalSurface<2> surface = connected_boundary(set);
    const auto contours = closed_contours(surface.surfels);
    ASSERT_EQ(contours.size(), surface.components());
    double area = 0;
    for (std::size_t c = 0; c < contours.size(); ++c) {
      ASSERT_EQ(contours[c].pointels.size(), surface.component_begin[c + 1] - surface.component_begin[c]);
      for (std::ptrdiff_t i = 0; i < contours[c].size(); ++i) {
        const Surfel<2>& linel = surface.surfels[surface.component_begin[c] + std::size_t(i)];
        ASSERT_EQ(contours[c][i], start_pointel(linel));
        ASSERT_EQ(contours[c][i + 1], end_pointel(linel));
      }
      area += signed_area(contours[c]);
    }
    EXPECT_EQ(area, double(set.size()));
  }
}

TEST(DigitalContour, IndicesGoAround) {
  const auto contours = closed_contours(connected_boundary(random_cells(1)).surfels);
  const DigitalContour& contour = contours[0];
  for (const std::ptrdiff_t i : {-1, 0, 5}) {
    EXPECT_EQ(contour[i], contour[i + contour.size()]);
    EXPECT_EQ(contour[i], contour[i - 3 * contour.size()]);
    EXPECT_EQ(contour.step(i).cwiseAbs().sum(), 1);
  }
}

TEST(DigitalContour, RefusesAnOpenContourByName) {
  auto linels = connected_boundary(random_cells(1)).surfels;
  const auto message = [](const std::vector<Surfel<2>>& range) -> std::string {
    try {
      closed_contours(range);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(linels), "");
  const auto k = linels[0].cell().coordinates;
  EXPECT_EQ(message({linels[0]}), "open contour: it ends with linel (" + std::to_string(k[0]) + ", " +
                                      std::to_string(k[1]) + ") (Khalimsky), away from its start");
  linels.erase(linels.begin() + 2);
  EXPECT_NE(message(linels).find("which does not start at its end"), std::string::npos);
}

}  // namespace
}  // namespace gridstep
