#include <gtest/gtest.h>

#include "estimators/contour/circular_arc.hpp"
#include "estimators/contour/testing_contours.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

/// rho(t) = 20 + 10 cos(6 t + 3) at h = 0.1.
std::vector<Surfel<2>> flower_linels() {
  return connected_boundary(
             gauss_digitize<2>(*make_shape<2>("flower:radius=20,amplitude=10,petals=6,phase=3"),
                               GridStep{0.1}))
      .surfels;
}

TEST(Mdca, GivesTheValuesOfTheReferenceLibrary) {
  // Khalimsky coordinates of linels all around the flower, and what DGtal 2.1.1 gives there.
  const struct {
    int kx, ky;
    double kappa;
  } reference[] = {{262, -261, 0.0264284725285}, {208, 15, -0.68599434057},
                   {235, 266, 0.023677558717},   {-104, 465, 0.0417146803512},
                   {-524, 229, 0.154608539286},  {-465, -182, 0.0543051192353},
                   {-96, -363, 0.0262045503991}, {173, -206, 0}};
  const auto linels = flower_linels();
  const auto kappa = estimate("mdca", linels, 0.1)["kappa"];
  int found = 0;
  for (std::size_t i = 0; i < linels.size(); ++i)
    for (const auto& [kx, ky, expected] : reference)
      if (linels[i].cell().coordinates == LatticePoint<2>(kx, ky)) {
        EXPECT_NEAR(kappa[i], expected, 1e-11) << kx << ' ' << ky;
        ++found;
      }
  EXPECT_EQ(found, 8);
}

/// For the pointel at which linel i starts: how far an arc reaches to both sides, in linels.
std::ptrdiff_t reach(const CircularArc& arc, std::ptrdiff_t i, std::ptrdiff_t n) {
  const std::ptrdiff_t before = ((i - arc.begin) % n + n) % n;
  return std::min(before, arc.size - before);
}

TEST(Mdca, TakesAnArcThatReachesFarthestToBothSides) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const auto linels = random_linels(seed, 25);
    const DigitalContour contour = closed_contours(linels).front();
    const auto arcs = maximal_arcs(contour);
    const auto kappa = estimate("mdca", linels, 0.5)["kappa"];
    for (std::ptrdiff_t i = 0; i < contour.size(); ++i) {
      std::ptrdiff_t farthest = -1;
      for (const CircularArc& arc : arcs) farthest = std::max(farthest, reach(arc, i, contour.size()));
      bool among_them = arcs.size() == 1;
      for (const CircularArc& arc : arcs)
        among_them |=
            reach(arc, i, contour.size()) == farthest && arc.curvature / 0.5 == kappa[std::size_t(i)];
      ASSERT_TRUE(among_them) << "seed " << seed << ", linel " << i;
    }
  }
}

TEST(LambdaMdca, IsBetweenTheCurvaturesOfTheArcsThatHoldTheLinel) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const auto linels = random_linels(seed, 25);
    const DigitalContour contour = closed_contours(linels).front();
    const auto arcs = maximal_arcs(contour);
    const auto kappa = estimate("lambda-mdca", linels, 1)["kappa"];
    for (std::ptrdiff_t i = 0; i < contour.size(); ++i) {
      double least = std::numeric_limits<double>::infinity(), most = -least;
      for (const CircularArc& arc : arcs) {
        const std::ptrdiff_t place = ((i - arc.begin) % contour.size() + contour.size()) % contour.size();
        if (place >= arc.size) continue;
        least = std::min(least, arc.curvature);
        most = std::max(most, arc.curvature);
      }
      ASSERT_GE(kappa[std::size_t(i)], least - 1e-12);
      ASSERT_LE(kappa[std::size_t(i)], most + 1e-12);
    }
  }
}

TEST(LambdaMdca, WeighsArcsByHowCentredTheLinelIs) {
  // By hand, at a few linels of the flower.
  const auto linels = flower_linels();
  const DigitalContour contour = closed_contours(linels).front();
  const auto arcs = maximal_arcs(contour);
  const auto kappa = estimate("lambda-mdca", linels, 0.1)["kappa"];
  for (const std::ptrdiff_t i : {100, 1234, 3000}) {
    double weights = 0, sum = 0;
    for (const CircularArc& arc : arcs) {
      const std::ptrdiff_t place = ((i - arc.begin) % contour.size() + contour.size()) % contour.size();
      if (place >= arc.size) continue;
      const double e = (double(place) + 0.5) / double(arc.size);
      const double weight = 64 * std::pow(e, 3) * std::pow(1 - e, 3);
      weights += weight;
      sum += weight * arc.curvature / 0.1;
    }
    EXPECT_NEAR(kappa[std::size_t(i)], sum / weights, 1e-12);
  }
}

}  // namespace
}  // namespace gridstep
