// Parity with dumps of the reference library, where the folder ../shared/reference is at hand. A few of their
// figures are carried in ii_test.cpp, for everywhere else.

#include <gtest/gtest.h>

#include <cmath>

#include "estimators/catalogue.hpp"
#include "estimators/testing_dumps.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

template <int d>
std::vector<int> key_of(const Surfel<d>& surfel) {
  const Cell<d> cell = surfel.cell();
  return {cell.coordinates.begin(), cell.coordinates.end()};
}

struct Case {
  const char* file;
  const char* shape;
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.file;
}

class ReferenceDump : public testing::TestWithParam<std::tuple<Case, Evaluation>> {
 protected:
  void SetUp() override {
    const auto path = dump_path(std::get<0>(GetParam()).file);
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference dumps here";
    dump = read_dump(path);
    ASSERT_FALSE(dump.rows.empty());
  }

  /// Estimates of every row's surfel, in the order of rows.
  template <int d>
  std::pair<Estimates, Estimates> estimate(const std::string& name) {
    const GridStep h{std::stod(dump.header.at("h"))};
    const auto shape = make_shape<d>(std::get<0>(GetParam()).shape);
    const DigitalSet<d> set = gauss_digitize<d>(*shape, h);
    std::map<std::vector<int>, Surfel<d>> surfels;
    for (const Surfel<d>& surfel : boundary(set)) surfels.emplace(key_of(surfel), surfel);
    EXPECT_EQ(surfels.size(), dump.rows.size());
    std::vector<Surfel<d>> ordered;
    for (std::size_t row = 0; row < dump.rows.size(); ++row) {
      std::vector<int> key{int(dump.at(row, "kx")), int(dump.at(row, "ky"))};
      if (d == 3) key.push_back(int(dump.at(row, "kz")));
      ordered.push_back(surfels.at(key));
    }
    auto estimator =
        find_estimator(name).variant<d>().make(set, {std::get<1>(GetParam()), KernelCentre::spels});
    estimator->init(h, {std::stod(dump.header.at("re"))});
    Estimates estimates = estimator->eval(ordered);
    return {std::move(estimates), estimator->raw()};
  }

  Dump dump;
};

class ReferenceDump2d : public ReferenceDump {};
class ReferenceDump3d : public ReferenceDump {};

TEST_P(ReferenceDump2d, SumsAreEqualAndCurvatureAgrees) {
  const auto [estimates, raw] = estimate<2>("ii");
  for (std::size_t i = 0; i < dump.rows.size(); ++i) {
    EXPECT_EQ(raw["sum"][i], dump.at(i, "raw_full"));
    EXPECT_NEAR(estimates["kappa"][i], dump.at(i, "kappa"), 1e-9);
  }
}

TEST_P(ReferenceDump3d, SumsAreEqualAndCurvaturesAgree) {
  const auto [mean, plain] = estimate<3>("ii");
  const auto [all, raw] = estimate<3>("ii-covariance");
  const std::pair<const char*, const char*> covariances[] = {{"cov_xx", "cxx"}, {"cov_xy", "cxy"},
                                                             {"cov_xz", "cxz"}, {"cov_yy", "cyy"},
                                                             {"cov_yz", "cyz"}, {"cov_zz", "czz"}};
  for (std::size_t i = 0; i < dump.rows.size(); ++i) {
    EXPECT_EQ(plain["sum"][i], dump.at(i, "raw"));
    EXPECT_EQ(raw["sum"][i], dump.at(i, "raw"));
    EXPECT_NEAR(mean["mean"][i], dump.at(i, "H"), 1e-9);
    const double scale = dump.at(i, "cxx") + dump.at(i, "cyy") + dump.at(i, "czz");
    for (const auto& [ours, theirs] : covariances)
      EXPECT_NEAR(raw[ours][i], dump.at(i, theirs), 1e-9 * scale);
    EXPECT_NEAR(all["k1"][i], dump.at(i, "k1"), 1e-7);
    EXPECT_NEAR(all["k2"][i], dump.at(i, "k2"), 1e-7);
  }
}

const auto kStrategies = testing::Values(Evaluation::full, Evaluation::masks, Evaluation::bricks);
const auto kName = [](const auto& info) {
  std::string name = std::string(std::get<0>(info.param).file) + "_" + to_string(std::get<1>(info.param));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
};

INSTANTIATE_TEST_SUITE_P(
    Dumps, ReferenceDump2d,
    testing::Combine(testing::Values(Case{"ii2d_ball5_h0.1_re1_EDGE.csv", "disk:radius=5"},
                                     Case{"ii2d_flower_h0.1_k3.csv",
                                          "flower:radius=20,amplitude=10,petals=6,phase=3"}),
                     kStrategies),
    kName);
INSTANTIATE_TEST_SUITE_P(Dumps, ReferenceDump3d,
                         testing::Combine(testing::Values(Case{"ii3d_sphere5_h0.5_k3.csv", "sphere:radius=5"},
                                                          Case{"ii3d_torus_h0.5_k2.csv",
                                                               "torus:major=6,minor=2"}),
                                          kStrategies),
                         kName);

}  // namespace
}  // namespace gridstep
