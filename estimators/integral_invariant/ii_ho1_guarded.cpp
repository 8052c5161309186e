#include <array>
#include <cmath>

#include "estimators/catalogue.hpp"
#include "estimators/integral_invariant/curvature.hpp"

namespace gridstep {

namespace {

struct Attempt {
  const char* estimator;
  double part;  // of R
};
// The second is the least ball with which ii-ho1 is less noisy than ii-pf1 with its usual one; parts are those of the
// usual k: 6, and 4, of 6.75.
constexpr std::array kAttempts{Attempt{"ii-ho1", 1}, Attempt{"ii-ho1", 6 / 6.75},
                               Attempt{"ii-pf1", 4 / 6.75}};

/// `ii-ho1` with a guard: where the ball has outgrown the feature, a smaller one, and then `ii-pf1`, which needs less of it.
///
/// A ball fits at a surfel where the set goes on below it, and is empty above it, as far as the ball does: along the
/// estimated normal, points at four distances up to R are inside on one side, outside on the other. A tube swallowed by
/// the ball fails, whatever its curvature. The decision is made for each surfel from what is around it alone; `raw()` has
/// the number of the attempt that was taken, EstimatorWork::fallbacks how often it was not the first.
///   Cost  that of `ii-ho1`, and of the other attempts where it does not fit.
class GuardedHigherOrder final : public Estimator<3> {
 public:
  GuardedHigherOrder(const DigitalSet<3>& set, EstimatorOptions options) : set_(set) {
    options.only.clear();  // the guard needs the normals
    for (std::size_t i = 0; i < kAttempts.size(); ++i)
      attempts_[i] = find_estimator(kAttempts[i].estimator).variant<3>().make(set, options);
  }

  void init(GridStep h, EuclideanLength R) override {
    for (std::size_t i = 0; i < kAttempts.size(); ++i) {
      // The first ball decides whether R is refused; smaller ones stop at one cell.
      radii_[i] = i == 0 ? R : EuclideanLength{std::max(kAttempts[i].part * R.value, h.value)};
      attempts_[i]->init(h, radii_[i]);
    }
    h_ = h;
  }

  Estimates eval(std::span<const Surfel<3>> surfels) override {
    Estimates result = attempts_[0]->eval(surfels);
    work_ = attempts_[0]->work();
    raw_ = {{"attempt"}, {std::vector<double>(surfels.size())}};
    std::vector<std::size_t> open = misfits(result, surfels, 0);
    work_.fallbacks = std::int64_t(open.size());
    for (std::size_t attempt = 1; attempt < kAttempts.size() && !open.empty(); ++attempt) {
      std::vector<Surfel<3>> rest;
      for (const std::size_t i : open) rest.push_back(surfels[i]);
      const Estimates estimates = attempts_[attempt]->eval(rest);
      work_.evaluations += attempts_[attempt]->work().evaluations;
      work_.cells_visited += attempts_[attempt]->work().cells_visited;
      for (std::size_t k = 0; k < open.size(); ++k) {
        raw_.columns[0][open[k]] = double(attempt);
        for (std::size_t c = 0; c < result.columns.size(); ++c)
          result.columns[c][open[k]] = estimates.columns[c][k];
      }
      std::vector<std::size_t> still;
      for (const std::size_t k : misfits(estimates, rest, attempt)) still.push_back(open[k]);
      open = std::move(still);
    }
    return result;
  }

  Estimates raw() const override { return raw_; }
  EstimatorWork work() const override { return work_; }

 private:
  std::vector<std::size_t> misfits(const Estimates& estimates, std::span<const Surfel<3>> surfels,
                                   std::size_t attempt) const {
    const std::array normal{&estimates["normal_x"], &estimates["normal_y"], &estimates["normal_z"]};
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
      const RealPoint<3> n{(*normal[0])[i], (*normal[1])[i], (*normal[2])[i]};
      if (!fits(centre(surfels[i], {1}), n, radii_[attempt].value / h_.value)) result.push_back(i);
    }
    return result;
  }
  bool fits(const RealPoint<3>& c, const RealPoint<3>& normal, double radius) const {
    // No simple fractions: along an axis, they would often end half-way between two lattice points.
    for (const double part : {0.26, 0.51, 0.76, 0.99})
      for (const int side : {-1, 1})
        if (set_.contains(nearest(c + side * part * radius * normal)) != (side < 0)) return false;
    return true;
  }
  static LatticePoint<3> nearest(const RealPoint<3>& p) { return p.array().round().cast<int>(); }

  const DigitalSet<3>& set_;
  std::array<std::unique_ptr<Estimator<3>>, kAttempts.size()> attempts_;
  std::array<EuclideanLength, kAttempts.size()> radii_{};
  GridStep h_{};
  Estimates raw_;
  EstimatorWork work_;
};

}  // namespace

EstimatorEntry describe_ii_ho1_guarded() {
  EstimatorEntry::Variant<3> variant;
  for (const char* quantity : kSurfaceQuantities) variant.quantities.push_back({quantity, std::nullopt});
  variant.make = [](const DigitalSet<3>& set, const EstimatorOptions& options) {
    return std::make_unique<GuardedHigherOrder>(set, options);
  };
  variant.usual_k = 6.75;
  variant.table_memory = [](DigitalLength radius) {  // of the three attempts
    const auto& one = find_estimator("ii-ho1").variant<3>().table_memory;
    double bytes = 0;
    for (const Attempt& attempt : kAttempts) bytes += one({attempt.part * radius.value});
    return bytes;
  };
  variant.evaluations = {Evaluation::full, Evaluation::bricks};
  variant.centres = {KernelCentre::surfel};
  return {
      "ii-ho1-guarded",
      "ii-ho1 where its ball fits the shape, else with a smaller one, else ii-pf1: all curvatures, principal "
      "directions and the normal (3D)",
      std::nullopt, std::move(variant)};
}

}  // namespace gridstep
