// Parity with a dump of the reference library, where it is at hand.

#include <gtest/gtest.h>

#include "estimators/catalogue.hpp"
#include "estimators/testing_dumps.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

// The dump gives to a linel the value of the arc that is the most centred one for its starting pointel, as we do.
TEST(ReferenceMdca, CurvatureIsEqualAtEveryLinel) {
  const auto path = dump_path("ref2d_flower_h0.1.csv");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference dumps here";
  const Dump dump = read_dump(path);
  const GridStep h{std::stod(dump.header.at("h"))};
  const auto shape = make_shape<2>("flower:radius=20,amplitude=10,petals=6,phase=3");
  const DigitalSet<2> set = gauss_digitize<2>(*shape, h);
  const auto linels = connected_boundary(set).surfels;
  ASSERT_EQ(linels.size(), dump.rows.size());
  auto estimator = find_estimator("mdca").variant<2>().make(set, {});
  estimator->init(h, {});
  const auto kappa = estimator->eval(linels)["kappa"];
  std::map<std::pair<int, int>, double> ours;
  for (std::size_t i = 0; i < linels.size(); ++i) {
    const auto k = linels[i].cell().coordinates;
    ours[{k[0], k[1]}] = kappa[i];
  }
  for (std::size_t row = 0; row < dump.rows.size(); ++row) {
    const double theirs = dump.at(row, "mdca");
    const auto found = ours.find({int(dump.at(row, "kx")), int(dump.at(row, "ky"))});
    ASSERT_NE(found, ours.end());
    EXPECT_NEAR(found->second, theirs, 1e-9 * std::max(1.0, std::abs(theirs))) << "row " << row;
  }
}

}  // namespace
}  // namespace gridstep
