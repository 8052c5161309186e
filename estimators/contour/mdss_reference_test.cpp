// Parity with a dump of the reference library, where it is at hand.

#include <gtest/gtest.h>

#include "estimators/catalogue.hpp"
#include "estimators/contour/digital_contour.hpp"
#include "estimators/testing_dumps.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

using Pointel = std::pair<int, int>;

// The dump has the starting pointel of each linel, in Khalimsky coordinates, and walks as we do, with the set
// on the left; only its first linel is another one. The flower does not touch itself: pointels are met once.
TEST(ReferenceMdss, CurvatureFromLengthIsEqualAtEveryPointel) {
  const auto path = dump_path("ref2d_flower_h0.1.csv");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference dumps here";
  const Dump dump = read_dump(path);
  const GridStep h{std::stod(dump.header.at("h"))};
  const auto shape = make_shape<2>("flower:radius=20,amplitude=10,petals=6,phase=3");
  const DigitalSet<2> set = gauss_digitize<2>(*shape, h);
  const auto linels = connected_boundary(set).surfels;
  ASSERT_EQ(linels.size(), dump.rows.size());
  auto estimator = find_estimator("mdss-length").variant<2>().make(set, {});
  estimator->init(h, {});
  const auto kappa = estimator->eval(linels)["kappa"];

  std::map<Pointel, double> ours;
  for (std::size_t i = 0; i < linels.size(); ++i) {
    const LatticePoint<2> p = pointel<2>(start_pointel(linels[i])).coordinates;
    ASSERT_TRUE(ours.emplace(Pointel(p[0], p[1]), kappa[i]).second);
  }
  for (std::size_t row = 0; row < dump.rows.size(); ++row) {
    const double theirs = dump.at(row, "mdss_l");
    const auto found = ours.find({int(dump.at(row, "px")), int(dump.at(row, "py"))});
    ASSERT_NE(found, ours.end());
    EXPECT_NEAR(found->second, theirs, 1e-9 * std::abs(theirs)) << "row " << row;
  }
}

}  // namespace
}  // namespace gridstep
