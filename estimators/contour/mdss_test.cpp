#include "estimators/contour/mdss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "estimators/contour/testing_contours.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

std::vector<Surfel<2>> linels_of(const DigitalSet<2>& set) {
  return connected_boundary(set).surfels;
}

std::vector<double> curvature(const std::string& name, const std::vector<Surfel<2>>& linels, double h) {
  return estimate(name, linels, h)["kappa"];
}

class MdssCurvature : public testing::TestWithParam<const char*> {
 protected:
  std::vector<double> kappa(const std::vector<Surfel<2>>& linels, double h = 1) const {
    return curvature(GetParam(), linels, h);
  }
};

TEST_P(MdssCurvature, HasTheSignOfTheCurvature) {
  const DigitalSet<2> disk = ball_set<2>(20.3);
  for (const double k : kappa(linels_of(disk))) EXPECT_GT(k, 0);
  const DigitalSet<2> ring =
      set_where<2>({LatticePoint<2>{-31, -31}, LatticePoint<2>{31, 31}}, [](const LatticePoint<2>& z) {
        const int r2 = z.squaredNorm();
        return r2 > 400 && r2 < 900;
      });
  const DigitalSurface<2> surface = connected_boundary(ring);
  ASSERT_EQ(surface.components(), 2u);
  const auto k = kappa(surface.surfels);
  for (std::size_t i = 0; i < k.size(); ++i) {
    const bool outside = i < surface.component_begin[1];
    EXPECT_GT(outside ? k[i] : -k[i], 0);
  }
}

// The sides of an L at its inner corner turn left at one end, right at the other.
TEST_P(MdssCurvature, IsZeroAtInflections) {
  const auto linels = linels_of(set_where<2>({LatticePoint<2>{-20, -20}, LatticePoint<2>{20, 20}},
                                             [](const LatticePoint<2>& z) { return z[0] < 0 || z[1] < 0; }));
  const auto k = kappa(linels);
  for (std::size_t i = 0; i < k.size(); ++i) {
    const LatticePoint<2> p = start_pointel(linels[i]);
    if (p[0] >= 0 && p[0] < 20 && p[1] >= 0 && p[1] < 20) {
      EXPECT_EQ(k[i], 0);
    }
    if (p[0] <= -19 || p[1] <= -19) {
      EXPECT_GT(k[i], 0);
    }
  }
}

TEST_P(MdssCurvature, ScalesLikeACurvature) {
  const auto linels = random_linels(2, 30);
  const auto k = kappa(linels), half = kappa(linels, 0.5);
  for (std::size_t i = 0; i < k.size(); ++i) EXPECT_EQ(half[i], 2 * k[i]);
}

TEST_P(MdssCurvature, DoesNotDependOnTheFirstLinelNorOnTheAxes) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto linels = random_linels(seed, 30);
    auto expected = kappa(linels);
    std::vector<Surfel<2>> turns;
    for (const Surfel<2>& linel : linels) turns.push_back(turned(linel));
    EXPECT_EQ(kappa(turns), expected);
    const auto shift = std::ptrdiff_t(linels.size() / 3);
    std::rotate(linels.begin(), linels.begin() + shift, linels.end());
    std::rotate(expected.begin(), expected.begin() + shift, expected.end());
    EXPECT_EQ(kappa(linels), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, MdssCurvature, testing::Values("mdss-length", "mdss-length-width"),
                         [](const auto& name) { return name.index == 0 ? "Length" : "LengthAndWidth"; });

// One cell: chords of length sqrt(2), at 1/sqrt(2) from the corner between. Three corners are on one circle.
TEST(Mdss, OneCell) {
  const auto linels = linels_of(ball_set<2>(0.5));
  for (const double k : curvature("mdss-length", linels, 0.25)) EXPECT_DOUBLE_EQ(k, 4 / 0.75);
  for (const double k : curvature("mdss-length-width", linels, 0.25)) EXPECT_DOUBLE_EQ(k, 4 * std::sqrt(2.0));
}

// A segment whose ends lean on one side, and whose middle leans on the other: the circle is that through the
// three. Such are some of the sides of a diamond.
TEST(Mdss, LengthAndWidthGiveTheCircleThroughThreePointels) {
  int met = 0;
  for (const int radius : {19, 20}) {
    const auto linels =
        linels_of(set_where<2>({LatticePoint<2>{-20, -20}, LatticePoint<2>{20, 20}},
                               [radius](const LatticePoint<2>& z) { return z.cwiseAbs().sum() <= radius; }));
    const DigitalContour contour = closed_contours(linels)[0];
    const TangentialCover cover(contour);
    const auto kappa = curvature("mdss-length-width", linels, 1);
    for (std::ptrdiff_t k = 0; k < cover.size(); ++k) {
      const auto [first, last, line] = cover[k];
      if (line.thickness() != 2 || (last - first) % 4 != 2) continue;
      const LatticePoint<2> u = contour[(first + last) / 2] - contour[first],
                            v = contour[last] - contour[first];
      const double area = std::abs(0.5 * (double(u[0]) * v[1] - double(u[1]) * v[0]));
      const auto length = [](const LatticePoint<2>& w) { return w.cast<double>().norm(); };
      const double expected = 4 * area / (length(u) * length(v) * length(v - u));
      EXPECT_NEAR(kappa[std::size_t(contour.index(cover.most_centred_for(k).end))], expected, 1e-12);
      ++met;
    }
  }
  EXPECT_GE(met, 4);
}

// Of the flower of mdss_reference_test.cpp, for where the dump is not at hand.
TEST(Mdss, FiguresOfTheReferenceLibrary) {
  const auto shape = make_shape<2>("flower:radius=20,amplitude=10,petals=6,phase=3");
  const auto linels = linels_of(gauss_digitize<2>(*shape, GridStep{0.1}));
  ASSERT_EQ(linels.size(), 3572u);
  const auto kappa = curvature("mdss-length", linels, 0.1);
  EXPECT_EQ(std::count_if(kappa.begin(), kappa.end(), [](double k) { return k > 0; }), 2910);
  EXPECT_EQ(std::count_if(kappa.begin(), kappa.end(), [](double k) { return k < 0; }), 340);
  EXPECT_EQ(std::count(kappa.begin(), kappa.end(), 0.0), 322);

  // On both sides of where another segment becomes the most centred one; Khalimsky coordinates.
  const std::map<std::pair<int, int>, double> expected{{{278, -268}, 0.0552104899931},
                                                       {{278, -270}, 0.0638467677574},
                                                       {{516, 260}, 0.314960629921},
                                                       {{516, 262}, 0.43956043956},
                                                       {{-112, 358}, 0.0284292821606},
                                                       {{-112, 356}, 0.0273878808627},
                                                       {{-276, -48}, 0},
                                                       {{-276, -50}, 0.0623052959502}};
  std::size_t met = 0;
  for (std::size_t i = 0; i < linels.size(); ++i) {
    const LatticePoint<2> p = pointel<2>(start_pointel(linels[i])).coordinates;
    const auto found = expected.find({p[0], p[1]});
    if (found == expected.end()) continue;
    EXPECT_NEAR(kappa[i], found->second, 1e-11 * std::abs(found->second)) << p.transpose();
    ++met;
  }
  EXPECT_EQ(met, expected.size());
}

}  // namespace
}  // namespace gridstep
