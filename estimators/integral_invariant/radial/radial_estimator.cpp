#include "estimators/integral_invariant/radial/radial_estimator.hpp"

#include <cmath>

#include "estimators/integral_invariant/radial/radial_curvature.hpp"
#include "estimators/integral_invariant/radial/radial_sums.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

/// Kernels end like 1 - t at the ball's boundary: smoothly enough for the lattice's own noise, and no wider than that.
constexpr int kEdgePower = 1;

RadialKernels kernels_of(int d, int vanishing) {
  // The wanted moment is that of order 2 for the trace, 0 and 2 for the distance and the normal, 4 for the deviator, to
  // which a distance adds nothing.
  std::vector<int> trace{0}, edge, tensor;
  for (int i = 1; i < vanishing; ++i) {
    trace.push_back(2 + 2 * i);
    edge.push_back(2 + 2 * i);
    tensor.push_back(4 + 2 * i);
  }
  return {vanishing_kernel(d, kEdgePower, trace), vanishing_kernel(d, kEdgePower, edge),
          vanishing_kernel(3, kEdgePower, tensor)};
}

template <int d>
class RadialIntegralInvariant final : public Estimator<d> {
 public:
  static std::vector<std::string> quantities() {
    if constexpr (d == 2) return {"kappa"};
    return {kSurfaceQuantities.begin(), kSurfaceQuantities.end()};
  }

  RadialIntegralInvariant(const DigitalSet<d>& set, const RadialKernels& kernels,
                          const EstimatorOptions& options)
      : mean_alone_(d == 3 && options.only == "mean"),
        sums_(set, kernels, options.evaluation, !mean_alone_),
        curvature_(kernels) {}

  void init(GridStep h, EuclideanLength R) override {
    R_ = R;
    digital_radius_ = to_digital(R, h).value;
    sums_.init(h, R);
  }

  Estimates eval(std::span<const Surfel<d>> surfels) override {
    const std::vector<RadialSum> sums = sums_.eval(surfels);
    Estimates result =
        Estimates::zeros(mean_alone_ ? std::vector<std::string>{"mean"} : quantities(), surfels.size());
    raw_ = Estimates::zeros(raw_names(), surfels.size());
    constexpr std::size_t kGrain = 256;
    parallel_chunks(surfels.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i) {
        raw_.set_row(i, raw_of(sums[i]));
        result.set_row(i, values_of(sums[i], surfels[i]));
      }
    });
    return result;
  }

  Estimates raw() const override { return raw_; }
  EstimatorWork work() const override { return sums_.work(); }

 private:
  std::vector<std::string> raw_names() const {
    if (d == 2 || mean_alone_) return {"trace_sum", "edge_sum"};
    return {"trace_sum", "edge_sum",  "edge_x",    "edge_y",    "edge_z",   "tensor_xx",
            "tensor_xy", "tensor_xz", "tensor_yy", "tensor_yz", "tensor_zz"};
  }
  static std::vector<std::int64_t> raw_of(const RadialSum& sum) {
    std::vector<std::int64_t> values{sum.trace, sum.edge};
    if constexpr (d == 3) {
      values.insert(values.end(), sum.edge_first.begin(), sum.edge_first.end());
      values.insert(values.end(), sum.tensor_second.begin(), sum.tensor_second.end());
    }
    return values;
  }

  std::vector<double> values_of(const RadialSum& sum, const Surfel<d>& surfel) const {
    const RadialSum& whole = sums_.whole(surfel.axis);
    const RadialWeights& weights = sums_.weights();
    const double cell = std::pow(digital_radius_, -d), half_cell = 0.5 / digital_radius_;
    // Twice the difference is an integer.
    const auto less_half = [](std::int64_t part, std::int64_t all) { return 0.5 * double(2 * part - all); };
    const double trace = weights.trace.unit() * cell * less_half(sum.trace, whole.trace);
    const double edge = weights.edge.unit() * cell * less_half(sum.edge, whole.edge);
    if constexpr (d == 2) {
      return {curvature_.in_2d(trace, edge) / R_.value};
    } else {
      if (mean_alone_) return {curvature_.mean_in_3d(trace, edge) / R_.value};
      Eigen::Vector3d first, outwards = Eigen::Vector3d::Zero();
      outwards[surfel.axis] = surfel.sign;
      Eigen::Matrix3d second;
      for (int i = 0, pair = 0; i < 3; ++i) {
        first[i] = weights.edge.unit() * cell * half_cell * double(sum.edge_first[std::size_t(i)]);
        for (int j = i; j < 3; ++j, ++pair)
          second(i, j) = second(j, i) =
              weights.tensor.unit() * cell * half_cell * half_cell *
              less_half(sum.tensor_second[std::size_t(pair)], whole.tensor_second[std::size_t(pair)]);
      }
      PrincipalCurvatures principal = curvature_.in_3d(trace, edge, first, second, outwards);
      principal.k1 /= R_.value;
      principal.k2 /= R_.value;
      const auto values =
          surface_values((principal.k1 + principal.k2) / 2, principal.k1 * principal.k2, principal);
      return {values.begin(), values.end()};
    }
  }

  bool mean_alone_;
  RadialSums<d> sums_;
  RadialCurvature curvature_;
  EuclideanLength R_{};
  double digital_radius_ = 0;
  Estimates raw_;
};

template <int d>
EstimatorEntry::Variant<d> variant(int vanishing, double usual_k) {
  EstimatorEntry::Variant<d> result;
  result.usual_k = usual_k;
  result.evaluations = {Evaluation::full,
                        Evaluation::bricks};  // a displacement mask would be as large as the kernel
  result.centres = {KernelCentre::surfel};
  // FluxTables, or prefix sums of rows, for surfels orthogonal to each axis.
  result.table_memory = [](DigitalLength radius) {
    const double lines = 2 * radius.value + 5;
    return d == 2 ? 2 * 16 * lines * lines : 3 * sizeof(WholeFlux) * lines * lines * (2 * radius.value + 33);
  };
  for (const std::string& quantity : RadialIntegralInvariant<d>::quantities())
    result.quantities.push_back({quantity, std::nullopt});
  result.make = [vanishing](const DigitalSet<d>& set, const EstimatorOptions& options) {
    return std::make_unique<RadialIntegralInvariant<d>>(set, kernels_of(d, vanishing), options);
  };
  return result;
}

}  // namespace

EstimatorEntry radial_entry(const std::string& name, const std::string& summary, const RadialFamily& family) {
  return {name, summary, variant<2>(family.vanishing, family.usual_k_2d),
          variant<3>(family.vanishing, family.usual_k_3d)};
}

}  // namespace gridstep
