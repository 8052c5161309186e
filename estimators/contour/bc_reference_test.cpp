// Parity with a dump of the reference library, where the folder ../shared/reference is at hand. A few of its
// figures are carried in bc_test.cpp, for everywhere else.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "estimators/catalogue.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

TEST(BinomialCurvatureReference, IsEqualInAllRows) {
  const auto path = std::filesystem::path(GRIDSTEP_SOURCE_DIR) / "../shared/reference/ref2d_flower_h0.1.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference dumps here";
  std::map<std::pair<int, int>, double> expected;  // by the Khalimsky coordinates of the linel
  std::ifstream file(path);
  std::string line, word;
  for (int skipped = 0; skipped < 2; ++skipped) std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<double> row;  // kx, ky, sign, px, py, mdca, mdss_l, mdss_lw, bc, ...
    for (std::istringstream values(line); std::getline(values, word, ',');) row.push_back(std::stod(word));
    expected[{int(row.at(0)), int(row.at(1))}] = row.at(8);
  }
  ASSERT_EQ(expected.size(), 3572u);

  const GridStep h{0.1};
  const DigitalSet<2> set =
      gauss_digitize<2>(*make_shape<2>("flower:radius=20,amplitude=10,petals=6,phase=3"), h);
  const auto linels = connected_boundary(set).surfels;
  ASSERT_EQ(linels.size(), expected.size());
  const auto estimator = find_estimator("bc").variant<2>().make(set, {});
  estimator->init(h, {1.0});
  const Estimates estimates = estimator->eval(linels);
  for (std::size_t i = 0; i < linels.size(); ++i) {
    const auto k = linels[i].cell().coordinates;
    EXPECT_NEAR(estimates["kappa"][i], expected.at({k[0], k[1]}), 1e-9);
  }
}

}  // namespace
}  // namespace gridstep
