#include "estimators/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "estimators/integral_invariant/kernel.hpp"
#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

// Contract tests: whatever is listed in estimators/catalogue.inc is tested here, with every option. Those that
// take no radius are tested in contour/contract_test.cpp.

namespace gridstep {
namespace {

struct Row {
  std::string estimator;
  EstimatorOptions options;

  template <int d>
  std::unique_ptr<Estimator<d>> make(const DigitalSet<d>& set) const {
    return find_estimator(estimator).variant<d>().make(set, options);
  }
  template <int d>
  Estimates eval(const DigitalSet<d>& set, const std::vector<Surfel<d>>& surfels, double R,
                 double h = 1) const {
    const auto made = make(set);
    made->init({h}, {R});
    return made->eval(surfels);
  }
};

std::string name_of(const Row& row) {
  std::string name = row.estimator + "_" + to_string(row.options.evaluation) +
                     (row.options.centre == KernelCentre::spels ? "_spels" : "_surfel");
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
std::ostream& operator<<(std::ostream& out, const Row& row) {
  return out << name_of(row);
}

template <int d>
std::vector<Row> rows() {
  std::vector<Row> result;
  for (const EstimatorEntry& entry : estimator_catalogue()) {
    if (d == 2 ? !entry.in_2d : !entry.in_3d) continue;
    if (!entry.not_built.empty() || !entry.variant<d>().takes_radius) continue;
    if (!entry.variant<d>().takes_options()) {
      result.push_back({entry.name, {}});
      continue;
    }
    for (const Evaluation evaluation : entry.variant<d>().evaluations)
      for (const KernelCentre centre : entry.variant<d>().centres)
        result.push_back({entry.name, {evaluation, centre}});
  }
  return result;
}

/// Curvatures are scalars under isometries; vectors come in threes (or twos) named _x, _y, _z.
bool is_vector(const std::string& quantity) {
  return quantity.size() > 2 && quantity[quantity.size() - 2] == '_';
}
bool has(const Estimates& estimates, const std::string& quantity) {
  return std::count(estimates.quantities.begin(), estimates.quantities.end(), quantity) > 0;
}
/// p where the quantity is a 1/length^p.
int power_of_length(const std::string& quantity) {
  return is_vector(quantity) ? 0 : quantity == "gaussian" ? 2 : 1;
}
template <int d>
RealPoint<d> vector_at(const Estimates& estimates, const std::string& name, std::size_t i) {
  RealPoint<d> v;
  for (int k = 0; k < d; ++k) v[k] = estimates[name + "_" + "xyz"[k]][i];
  return v;
}

/// A slanted ellipse or ellipsoid with no lattice symmetry, across zero and across bricks.
template <int d>
DigitalSet<d> slanted_set(const LatticePoint<d>& shift = LatticePoint<d>::Zero(), int margin = 17) {
  return set_where<d>({shift.array() - margin, shift.array() + margin}, [&](const LatticePoint<d>& z) {
    RealPoint<d> p = (z - shift).template cast<double>();
    p[0] -= 0.3 * p[1] - 0.21;
    p[1] += 0.2 * p[d - 1];
    p[d - 1] *= 1.6;
    return p.squaredNorm() <= 12.3 * 12.3;
  });
}

/// A lattice isometry z -> M z + t, M a signed permutation.
template <int d>
struct Isometry {
  Eigen::Matrix<int, d, d> M;
  LatticePoint<d> t;

  LatticePoint<d> operator()(const LatticePoint<d>& z) const { return M * z + t; }
  DigitalSet<d> operator()(const DigitalSet<d>& set) const {
    const LatticePoint<d> a = (*this)(set.domain().lo), b = (*this)(set.domain().hi);
    DigitalSet<d> image({a.cwiseMin(b), a.cwiseMax(b)});
    for_each_point_of(set, [&](const LatticePoint<d>& z) { image.set((*this)(z), true); });
    return image;
  }
  Surfel<d> operator()(const Surfel<d>& surfel) const {
    const LatticePoint<d> inner = (*this)(surfel.inner), normal = (*this)(surfel.outer()) - inner;
    int axis;
    normal.cwiseAbs().maxCoeff(&axis);
    return {inner, std::int8_t(axis), std::int8_t(normal[axis])};
  }
};

/// Estimates on the image equal the image of the estimates.
template <int d>
void expect_commutes(const Row& row, const Isometry<d>& move, double R) {
  const auto set = slanted_set<d>();
  const auto surfels = boundary(set);
  std::vector<Surfel<d>> moved;
  for (const Surfel<d>& surfel : surfels) moved.push_back(move(surfel));
  const Estimates here = row.eval<d>(set, surfels, R), there = row.eval<d>(move(set), moved, R);
  const Eigen::Matrix<double, d, d> M = move.M.template cast<double>();
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    for (const std::string& quantity : here.quantities) {
      if (!is_vector(quantity)) {
        EXPECT_NEAR(there[quantity][i], here[quantity][i], 1e-10) << quantity;
      }
    }
    if (has(here, "normal_x")) {
      EXPECT_NEAR((vector_at<d>(there, "normal", i) - M * vector_at<d>(here, "normal", i)).norm(), 0, 1e-9);
    }
    if (has(here, "dir1_x")) {
      // Directions have no sign, and none at all where the curvatures are equal.
      const double gap = here["k1"][i] - here["k2"][i];
      for (const std::string name : {"dir1", "dir2"}) {
        const RealPoint<d> a = vector_at<d>(there, name, i), b = M * vector_at<d>(here, name, i);
        EXPECT_NEAR(gap * (a * a.transpose() - b * b.transpose()).norm(), 0, 1e-9);
      }
    }
  }
}

template <int d>
void GivesAFiniteValueForEverySurfelAndQuantity(const Row& row) {
  const auto& variant = find_estimator(row.estimator).variant<d>();
  const auto set = random_set<d>({LatticePoint<d>::Constant(-9), LatticePoint<d>::Constant(9)}, 0.5, 11);
  const auto surfels = boundary(set);
  for (const double R : {1.0, 1.2, 2.0, 6.5}) {
    const Estimates estimates = row.eval<d>(set, surfels, R);
    ASSERT_EQ(estimates.quantities.size(), variant.quantities.size());
    ASSERT_EQ(estimates.columns.size(), variant.quantities.size());
    for (std::size_t c = 0; c < variant.quantities.size(); ++c) {
      EXPECT_EQ(estimates.quantities[c], variant.quantities[c].name);
      ASSERT_EQ(estimates.columns[c].size(), surfels.size());
      for (const double value : estimates.columns[c]) ASSERT_TRUE(std::isfinite(value)) << R;
    }
  }
  EXPECT_TRUE(row.eval<d>(set, {}, 3).columns.front().empty());
}

template <int d>
void KeepsTheOrderOfTheSurfels(const Row& row) {
  const auto set = slanted_set<d>();
  const auto surfels = boundary(set);
  std::vector<std::size_t> order(surfels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomStream random({12});
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(std::uint32_t(i))]);
  std::vector<Surfel<d>> shuffled;
  for (const std::size_t i : order) shuffled.push_back(surfels[i]);
  shuffled.push_back(shuffled.front());  // and a surfel may be asked for twice

  const Estimates sorted = row.eval<d>(set, surfels, 3.3), mixed = row.eval<d>(set, shuffled, 3.3);
  for (std::size_t c = 0; c < sorted.columns.size(); ++c) {
    for (std::size_t i = 0; i < order.size(); ++i)
      ASSERT_EQ(mixed.columns[c][i], sorted.columns[c][order[i]]) << sorted.quantities[c];
    EXPECT_EQ(mixed.columns[c].back(), mixed.columns[c].front());
  }
}

template <int d>
void OneSurfelIsARangeOfOne(const Row& row) {
  const auto set = slanted_set<d>();
  const auto surfels = boundary(set);
  const auto estimator = row.make<d>(set);
  estimator->init({0.5}, {2.2});
  const Estimates all = estimator->eval(surfels);
  for (std::size_t i = 0; i < surfels.size(); i += 97) {
    const Estimates one = estimator->eval(surfels[i]);
    for (std::size_t c = 0; c < all.columns.size(); ++c) {
      ASSERT_EQ(one.columns[c].size(), 1u);
      EXPECT_EQ(one.columns[c][0], all.columns[c][i]) << all.quantities[c];
    }
  }
}

template <int d>
void CommutesWithTranslations(const Row& row) {
  LatticePoint<d> far = LatticePoint<d>::Constant(-311);
  far[1] = 1003;
  for (const LatticePoint<d>& t : {LatticePoint<d>(LatticePoint<d>::Ones()), far})
    expect_commutes<d>(row, {Eigen::Matrix<int, d, d>::Identity(), t}, 4.1);
}

template <int d>
void CommutesWithMirrorsAndAxisSwaps(const Row& row) {
  for (int axis = 0; axis < d; ++axis) {
    Isometry<d> mirror{Eigen::Matrix<int, d, d>::Identity(), LatticePoint<d>::Zero()};
    mirror.M(axis, axis) = -1;
    expect_commutes<d>(row, mirror, 3.9);
    Isometry<d> swap{Eigen::Matrix<int, d, d>::Identity(), LatticePoint<d>::Constant(axis)};
    swap.M.row(axis).swap(swap.M.row((axis + 1) % d));
    expect_commutes<d>(row, swap, 3.9);
  }
}

template <int d>
void ScalesLikeACurvature(const Row& row) {
  // The cells of X at step h are the cells of sX at step sh.
  const auto set = slanted_set<d>();
  const auto surfels = boundary(set);
  for (const double s : {4.0, 0.3}) {
    const Estimates unit = row.eval<d>(set, surfels, 2.1, 0.5),
                    scaled = row.eval<d>(set, surfels, s * 2.1, s * 0.5);
    for (std::size_t c = 0; c < unit.columns.size(); ++c) {
      const int p = power_of_length(unit.quantities[c]);
      for (std::size_t i = 0; i < surfels.size(); ++i)
        ASSERT_NEAR(scaled.columns[c][i] * std::pow(s, p), unit.columns[c][i], 1e-9) << unit.quantities[c];
    }
  }
}

template <int d>
void FlipsItsSignOnTheComplement(const Row& row) {
  const double R = 9;  // small balls are not as round: see the exact relation below
  const auto set = slanted_set<d>();
  const LatticeBox<d> box{LatticePoint<d>::Constant(-26), LatticePoint<d>::Constant(26)};
  const auto outside = complement(set, box);
  const auto surfels = boundary(set);
  std::vector<Surfel<d>> turned;
  for (const Surfel<d>& surfel : surfels)
    turned.push_back({surfel.outer(), surfel.axis, std::int8_t(-surfel.sign)});
  const Estimates in = row.eval<d>(set, surfels, R), out = row.eval<d>(outside, turned, R);
  const std::string quantity = d == 2 ? "kappa" : "mean";
  ASSERT_TRUE(has(in, quantity) || has(in, "normal_x"));
  if (has(in, quantity)) {
    double mean = 0, defect = 0;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
      mean += in[quantity][i] / double(surfels.size());
      defect += (in[quantity][i] + out[quantity][i]) / double(surfels.size());
    }
    EXPECT_GT(mean, 0.04);
    EXPECT_LT(std::abs(defect), 0.3 * mean);
  }
  if (!has(in, "normal_x")) return;
  for (std::size_t i = 0; i < surfels.size(); ++i)
    EXPECT_LT(vector_at<d>(in, "normal", i).dot(vector_at<d>(out, "normal", i)), -0.8);
}

template <int d>
void IsPositiveOnAConvexSet(const Row& row) {
  const auto set = ball_set<d>(d == 2 ? 30 : 20);
  const auto surfels = boundary(set);
  // A ball large enough for the noisiest kernel.
  const Estimates estimates = row.eval<d>(set, surfels, d == 2 ? 18 : 14);
  for (std::size_t c = 0; c < estimates.columns.size(); ++c) {
    if (is_vector(estimates.quantities[c])) continue;
    for (const double value : estimates.columns[c]) EXPECT_GT(value, 0) << estimates.quantities[c];
  }
}

template <int d>
void HasOrthonormalFramesWithTheNormalOutwards(const Row& row) {
  const auto set = ball_set<d>(15);
  const auto surfels = boundary(set);
  const Estimates estimates = row.eval<d>(set, surfels, 5.5);
  if (!has(estimates, "normal_x")) return;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    const RealPoint<d> normal = vector_at<d>(estimates, "normal", i);
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
    EXPECT_GT(normal.dot(centre(surfels[i], 1).normalized()), 0.95);
    if (!has(estimates, "dir1_x")) continue;
    const RealPoint<d> dir1 = vector_at<d>(estimates, "dir1", i), dir2 = vector_at<d>(estimates, "dir2", i);
    EXPECT_NEAR(dir1.norm(), 1, 1e-12);
    EXPECT_NEAR(dir2.norm(), 1, 1e-12);
    EXPECT_NEAR(dir1.dot(dir2), 0, 1e-12);
    EXPECT_NEAR(dir1.dot(normal), 0, 1e-12);
    EXPECT_NEAR(dir2.dot(normal), 0, 1e-12);
  }
}

template <int d>
void OrientsTheNormalEvenForTheSmallestKernels(const Row& row) {
  // Flat surfels far from the edges of a box: the direction is exact, so only its sign can be wrong.
  const auto set = set_where<d>({LatticePoint<d>::Constant(-9), LatticePoint<d>::Constant(8)},
                                [](const LatticePoint<d>&) { return true; });
  std::vector<Surfel<d>> flat;
  for (const Surfel<d>& surfel : boundary(set)) {
    RealPoint<d> along = centre(surfel, 1);
    along[surfel.axis] = 0;
    if (along.cwiseAbs().maxCoeff() < 4) flat.push_back(surfel);
  }
  ASSERT_GE(flat.size(), std::size_t(2 * d));
  for (const double R : {1.2, 1.5, 2.0, 3.0, 4.2}) {
    const Estimates estimates = row.eval<d>(set, flat, R);
    if (!has(estimates, "normal_x")) return;
    for (std::size_t i = 0; i < flat.size(); ++i)
      EXPECT_NEAR((vector_at<d>(estimates, "normal", i) - flat[i].normal()).norm(), 0, 1e-9) << R;
  }
}

/// The kernels of ii-ho2 change their signs two or three times, which a ball of two cells does not resolve.
double times_radius(const Row& row) {
  return row.estimator == "ii-ho2" ? 2 : 1;
}

template <int d>
void OrientsTheNormalInAHollow(const Row& row) {
  const auto hollow =
      complement(ball_set<d>(9), {LatticePoint<d>::Constant(-13), LatticePoint<d>::Constant(13)});
  std::vector<Surfel<d>> inside;
  for (const Surfel<d>& surfel : boundary(hollow))
    if (centre(surfel, 1).norm() < 11) inside.push_back(surfel);
  for (const double R : {2.0, 3.1}) {
    const Estimates estimates = row.eval<d>(hollow, inside, R * times_radius(row));
    if (!has(estimates, "normal_x")) return;
    for (std::size_t i = 0; i < inside.size(); ++i)
      EXPECT_LT(vector_at<d>(estimates, "normal", i).dot(centre(inside[i], 1).normalized()), -0.6) << R;
  }
}

/// Corrected currents have a measure for each curvature: their mean and gaussian are not made of k1 and k2.
bool measures_each_curvature(const Row& row) {
  return row.estimator == "icnc" || row.estimator == "ccnc";
}

template <int d>
void OrdersItsPrincipalCurvatures(const Row& row) {
  for (const auto& set :
       {slanted_set<d>(),
        random_set<d>({LatticePoint<d>::Constant(0), LatticePoint<d>::Constant(20)}, 0.6, 13)}) {
    const auto surfels = boundary(set);
    const Estimates estimates = row.eval<d>(set, surfels, 4.4);
    if (!has(estimates, "k1")) return;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
      const double k1 = estimates["k1"][i], k2 = estimates["k2"][i];
      EXPECT_GE(k1, k2);
      if (measures_each_curvature(row)) continue;
      EXPECT_NEAR(estimates["mean"][i], (k1 + k2) / 2, 1e-12);
      EXPECT_NEAR(estimates["gaussian"][i], k1 * k2, 1e-12);
    }
  }
}

template <int d>
void AgreesExactlyWithTheFullKernel(const Row& row) {
  for (const double density : {0.2, 0.6, 1.0}) {
    const auto set =
        random_set<d>({LatticePoint<d>::Constant(-12), LatticePoint<d>::Constant(9)}, density, 14);
    const auto surfels = boundary(set);
    Row plain = row;
    plain.options.evaluation = Evaluation::full;
    const auto fast = row.make<d>(set), full = plain.make<d>(set);
    for (const double R : {1.0, 3.1, 4.0}) {
      fast->init({1}, {R});
      full->init({1}, {R});
      const Estimates a = fast->eval(surfels), b = full->eval(surfels);
      EXPECT_TRUE(fast->raw().quantities == full->raw().quantities);
      EXPECT_TRUE(fast->raw().columns == full->raw().columns) << R;
      EXPECT_TRUE(a.columns == b.columns) << R;
      EXPECT_EQ(fast->work().evaluations, full->work().evaluations);
    }
  }
}

template <int d>
void CountsItsWork(const Row& row) {
  const auto set = slanted_set<d>();
  const auto surfels = boundary(set);
  const auto estimator = row.make<d>(set);
  estimator->init({1}, {5});
  for (int repeated = 0; repeated < 2; ++repeated) {  // the work of the last eval(), not of all
    estimator->eval(surfels);
    const EstimatorWork work = estimator->work();
    EXPECT_GT(work.evaluations, 0);
    if (!find_estimator(row.estimator).variant<d>().takes_options()) continue;  // no sums over balls
    EXPECT_LE(work.evaluations, std::int64_t(2 * surfels.size()));
    EXPECT_EQ(work.kernel_size,
              std::int64_t(ball_kernel<d>({5}, row.options.centre == KernelCentre::spels ? -1 : 0).size()));
    if (row.options.evaluation == Evaluation::full) {
      EXPECT_EQ(work.cells_visited, work.evaluations * work.kernel_size);
      EXPECT_EQ(work.restarts, 0);
      EXPECT_TRUE(work.mask_sizes.empty());
    } else if (row.options.evaluation == Evaluation::masks) {
      EXPECT_LT(work.cells_visited, work.evaluations * work.kernel_size);
      EXPECT_GT(work.restarts, 0);
      EXPECT_FALSE(work.mask_sizes.empty());
    } else {
      EXPECT_GT(work.cells_visited, 0);
      EXPECT_LT(work.cells_visited, work.evaluations * work.kernel_size);
      EXPECT_EQ(work.restarts, 0);
      EXPECT_TRUE(work.mask_sizes.empty());
    }
  }
}

template <int d>
void MustBeInitialized(const Row& row) {
  const auto set = ball_set<d>(5);
  const auto surfels = boundary(set);
  const auto estimator = row.make<d>(set);
  EXPECT_THROW(estimator->eval(surfels), ContractViolation);
  EXPECT_THROW(estimator->init({0}, {1}), ContractViolation);
  EXPECT_THROW(estimator->init({-1}, {1}), ContractViolation);
  EXPECT_THROW(estimator->init({1}, {0.9}), InputError);
  EXPECT_THROW(estimator->init({1}, {std::nan("")}), InputError);
  EXPECT_NO_THROW(estimator->init({1}, {1}));
  EXPECT_NO_THROW(estimator->eval(surfels));
  EXPECT_THROW(estimator->init({1}, {0.9}), InputError);
  EXPECT_THROW(estimator->eval(surfels), ContractViolation) << "a failed init() leaves nothing behind";
}

template <int d>
void ForgetsTheRadiusBefore(const Row& row) {
  const auto set = slanted_set<d>();
  const auto surfels = boundary(set);
  const auto estimator = row.make<d>(set);
  for (const double R : {5.0, 3.0, 4.5}) {
    estimator->init({0.5}, {R});
    EXPECT_TRUE(estimator->eval(surfels).columns == row.eval<d>(set, surfels, R, 0.5).columns);
  }
}

class EstimatorContract2d : public testing::TestWithParam<Row> {};
class EstimatorContract3d : public testing::TestWithParam<Row> {};

#define GRIDSTEP_CONTRACT(name)       \
  TEST_P(EstimatorContract2d, name) { \
    name<2>(GetParam());              \
  }                                   \
  TEST_P(EstimatorContract3d, name) { \
    name<3>(GetParam());              \
  }
GRIDSTEP_CONTRACT(GivesAFiniteValueForEverySurfelAndQuantity)
GRIDSTEP_CONTRACT(KeepsTheOrderOfTheSurfels)
GRIDSTEP_CONTRACT(OneSurfelIsARangeOfOne)
GRIDSTEP_CONTRACT(CommutesWithTranslations)
GRIDSTEP_CONTRACT(CommutesWithMirrorsAndAxisSwaps)
GRIDSTEP_CONTRACT(ScalesLikeACurvature)
GRIDSTEP_CONTRACT(FlipsItsSignOnTheComplement)
GRIDSTEP_CONTRACT(IsPositiveOnAConvexSet)
GRIDSTEP_CONTRACT(HasOrthonormalFramesWithTheNormalOutwards)
GRIDSTEP_CONTRACT(OrientsTheNormalEvenForTheSmallestKernels)
GRIDSTEP_CONTRACT(OrientsTheNormalInAHollow)
GRIDSTEP_CONTRACT(OrdersItsPrincipalCurvatures)
GRIDSTEP_CONTRACT(AgreesExactlyWithTheFullKernel)
GRIDSTEP_CONTRACT(CountsItsWork)
GRIDSTEP_CONTRACT(MustBeInitialized)
GRIDSTEP_CONTRACT(ForgetsTheRadiusBefore)
#undef GRIDSTEP_CONTRACT

const auto kName = [](const auto& tested) { return name_of(tested.param); };
INSTANTIATE_TEST_SUITE_P(Catalogue, EstimatorContract2d, testing::ValuesIn(rows<2>()), kName);
INSTANTIATE_TEST_SUITE_P(Catalogue, EstimatorContract3d, testing::ValuesIn(rows<3>()), kName);

/// The counts of a set and of its complement add up to the kernel's N, so with surfels turned around
///   kappa + kappa' = 3/R^3 (pi R^2 - h^2 N),   H + H' = 4/(pi R^4) (4/3 pi R^3 - h^3 N).
template <int d>
void expect_exact_complement(KernelCentre kernel_centre) {
  const double h = 0.5, R = 3.1;
  const auto set = slanted_set<d>();
  const LatticeBox<d> box{LatticePoint<d>::Constant(-26), LatticePoint<d>::Constant(26)};
  const auto outside = complement(set, box);
  const auto surfels = boundary(set);
  std::vector<Surfel<d>> turned;
  for (const Surfel<d>& surfel : surfels)
    turned.push_back({surfel.outer(), surfel.axis, std::int8_t(-surfel.sign)});
  const Row row{"ii", {Evaluation::masks, kernel_centre}};
  const Estimates in = row.eval<d>(set, surfels, R, h), out = row.eval<d>(outside, turned, R, h);
  const auto N = double(ball_kernel<d>({R / h}, kernel_centre == KernelCentre::spels ? -1 : 0).size());
  using std::numbers::pi;
  const double sum = d == 2 ? 3 / std::pow(R, 3) * (pi * R * R - h * h * N)
                            : 4 / (pi * std::pow(R, 4)) * (4 * pi / 3 * std::pow(R, 3) - std::pow(h, 3) * N);
  for (std::size_t i = 0; i < surfels.size(); ++i)
    ASSERT_NEAR(in.columns[0][i] + out.columns[0][i], sum, 1e-12);
}

TEST(IntegralInvariant, OfTheComplementIsMinusItUpToTheDefectOfTheDigitalBall) {
  for (const KernelCentre kernel_centre : {KernelCentre::spels, KernelCentre::surfel}) {
    expect_exact_complement<2>(kernel_centre);
    expect_exact_complement<3>(kernel_centre);
  }
}

TEST(EstimatorCatalogue, HasDistinctNamesAndSummaries) {
  std::set<std::string> names;
  for (const EstimatorEntry& entry : estimator_catalogue()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.summary.empty());
    EXPECT_TRUE(entry.in_2d || entry.in_3d);
    EXPECT_EQ(&find_estimator(entry.name), &entry);
  }
}

TEST(EstimatorCatalogue, NamesWhatItDoesNotKnow) {
  const auto message = [](auto call) -> std::string {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message([] { find_estimator("iii"); }).rfind("unknown estimator 'iii'; known: ii, ", 0), 0u);
  EXPECT_EQ(message([] { parse_kernel_centre("pointel"); }),
            "unknown kernel centre 'pointel'; known: spels, surfel");
  EXPECT_EQ(message([] { (void)find_estimator("ii-covariance").variant<2>(); }),
            "estimator 'ii-covariance' has no 2D form");
  EXPECT_EQ(parse_kernel_centre("spels"), KernelCentre::spels);
  EXPECT_EQ(parse_kernel_centre("surfel"), KernelCentre::surfel);
  EXPECT_THROW((void)Estimates()["kappa"], ContractViolation);
}

}  // namespace
}  // namespace gridstep
