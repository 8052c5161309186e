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
// Parts are those of the usual k: 6, 5.5, 5, and 4, of 6.75. Below 5, ii-ho1 is noisier than ii-pf1 with its usual ball.
constexpr std::array kAttempts{Attempt{"ii-ho1", 1}, Attempt{"ii-ho1", 6 / 6.75},
                               Attempt{"ii-ho1", 5.5 / 6.75}, Attempt{"ii-ho1", 5 / 6.75},
                               Attempt{"ii-pf1", 4 / 6.75}};

/// `ii-ho1` with a guard: where the ball has outgrown the feature, a smaller one, and then `ii-pf1`, which needs less of it.
///
/// A ball fits at a surfel where the set goes on below it, and is empty above it, further than the ball does: along the
/// estimated normal, points at four distances up to 1.13 R are inside on one side, outside on the other. A tube that the
/// ball comes near to swallowing fails, whatever its curvature: on a torus, errors are least where R is .87 of its width. The decision is made for each surfel from what is around it alone; `raw()` has
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
    h_ = h;
    R_ = R;
    ready_ = 0;
    prepare(0);
  }

  Estimates eval(std::span<const Surfel<3>> surfels) override {
    Estimates result = attempts_[0]->eval(surfels);
    work_ = attempts_[0]->work();
    raw_ = Estimates::zeros({"attempt"}, surfels.size());
    std::vector<std::size_t> open = misfits(result, surfels, 0);
    work_.fallbacks = std::int64_t(open.size());
    for (std::size_t attempt = 1; attempt < kAttempts.size() && !open.empty(); ++attempt) {
      std::vector<Surfel<3>> rest;
      for (const std::size_t i : open) rest.push_back(surfels[i]);
      prepare(attempt);
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
  /// The first ball decides whether R is refused; smaller ones stop at one cell, and have no tables before they are needed.
  EuclideanLength radius(std::size_t attempt) const {
    return {attempt == 0 ? R_.value : std::max(kAttempts[attempt].part * R_.value, h_.value)};
  }
  void prepare(std::size_t attempt) {
    for (; ready_ <= attempt; ++ready_) attempts_[ready_]->init(h_, radius(ready_));
  }
  std::vector<std::size_t> misfits(const Estimates& estimates, std::span<const Surfel<3>> surfels,
                                   std::size_t attempt) const {
    const std::array normal{&estimates["normal_x"], &estimates["normal_y"], &estimates["normal_z"]};
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
      const RealPoint<3> n{(*normal[0])[i], (*normal[1])[i], (*normal[2])[i]};
      if (!fits(centre(surfels[i], {1}), n, to_digital(radius(attempt), h_).value)) result.push_back(i);
    }
    return result;
  }
  bool fits(const RealPoint<3>& c, const RealPoint<3>& normal, double radius) const {
    // No simple fractions: along an axis, they would often end half-way between two lattice points.
    for (const double part : {0.29, 0.57, 0.86, 1.13})
      for (const int side : {-1, 1})
        if (set_.contains(nearest(c + side * part * radius * normal)) != (side < 0)) return false;
    return true;
  }
  static LatticePoint<3> nearest(const RealPoint<3>& p) { return p.array().round().cast<int>(); }

  const DigitalSet<3>& set_;
  std::array<std::unique_ptr<Estimator<3>>, kAttempts.size()> attempts_;
  std::size_t ready_ = 0;  // attempts that are
  GridStep h_{};
  EuclideanLength R_{};
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
  variant.table_memory = [](DigitalLength radius) {  // of all attempts
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
