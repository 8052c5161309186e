// Integral invariants over whole surfaces, one thread: evaluation alone, after init() and with the surfels at
// hand. Names are invariant/<dimension>/<sums>/<strategy>/R:<R/h>; every strategy is compared with `full` on
// the same surfels before it is timed.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <ctime>
#include <map>

#include "estimators/integral_invariant/surfel_sums.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

/// The ball around a point off the lattice; h = 1, so that lengths are in cells.
template <int d>
class OffCentreBall final : public Region<d> {
 public:
  explicit OffCentreBall(double radius) : radius_(radius) {
    for (int k = 0; k < d; ++k) centre_[k] = 0.13 + 0.24 * k;
  }
  RealBox<d> bounds() const override { return {centre_.array() - radius_, centre_.array() + radius_}; }
  AffineBound<d> bound(const RealBox<d>& box) const override {
    // |p - c|^2 - radius^2 around the middle m of the box, but for |p - m|^2 and the rounding of inside().
    const RealPoint<d> middle = box.center(), from_centre = middle - centre_;
    return {middle, from_centre.squaredNorm() - radius_ * radius_, 2 * from_centre,
            box.sizes().squaredNorm() / 4 * (1 + 1e-12) + 1e-12 * radius_ * radius_};
  }
  std::uint64_t inside(std::span<const RealPoint<d>> points) const override {
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      result |= std::uint64_t((points[i] - centre_).squaredNorm() <= radius_ * radius_) << i;
    return result;
  }

 private:
  RealPoint<d> centre_;
  double radius_;
};

template <int d>
struct Surface {
  DigitalSet<d> set;
  std::vector<Surfel<d>> surfels;
};

/// The surfaces are large enough for kernels to be mostly cut, and as small as `full` at the largest R/h
/// needs.
template <int d>
const Surface<d>& surface() {
  static const Surface<d> result = [] {
    DigitalSet<d> set = gauss_digitize<d>(OffCentreBall<d>(d == 2 ? 400 : 60), {1});
    std::vector<Surfel<d>> surfels = boundary(set);
    return Surface<d>{std::move(set), std::move(surfels)};
  }();
  return result;
}

template <int d, class Sum>
using Pairs = std::vector<typename SurfelSums<d, Sum>::Pair>;

template <int d, class Sum>
Pairs<d, Sum> evaluate(double R, Evaluation evaluation) {
  SurfelSums<d, Sum> sums(surface<d>().set, {evaluation, KernelCentre::spels});
  sums.init({1}, {R});
  return sums.eval(surface<d>().surfels);
}

/// What `full` gives; computed once for each radius.
template <int d, class Sum>
const Pairs<d, Sum>& reference(double R) {
  static std::map<double, Pairs<d, Sum>> known;
  auto found = known.find(R);
  if (found == known.end()) found = known.emplace(R, evaluate<d, Sum>(R, Evaluation::full)).first;
  return found->second;
}

template <int d, class Sum>
void invariant(benchmark::State& state, Evaluation evaluation) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const double R = double(state.range(0));
  const auto& surfels = surface<d>().surfels;
  SurfelSums<d, Sum> sums(surface<d>().set, {evaluation, KernelCentre::spels});
  sums.init({1}, {R});
  if (evaluation != Evaluation::full) {
    const Pairs<d, Sum> own = sums.eval(surfels);
    const Pairs<d, Sum>& expected = reference<d, Sum>(R);
    for (std::size_t i = 0; i < surfels.size(); ++i)
      if (!(own[i].inner == expected[i].inner && own[i].outer == expected[i].outer)) {
        state.SkipWithError("differs from the full kernel");
        return;
      }
  }
  const std::clock_t begin = std::clock();  // of the process, which has one thread
  for (auto _ : state) benchmark::DoNotOptimize(sums.eval(surfels));
  const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
  state.SetComplexityN(state.range(0));
  state.counters["ns_per_surfel"] = 1e9 * seconds / (double(state.iterations()) * double(surfels.size()));
  state.counters["surfels"] = double(surfels.size());
  state.counters["cells_visited"] = double(sums.work().cells_visited);
  state.counters["restarts"] = double(sums.work().restarts);
}

/// `growth` is what the time of a surfel is known to grow like in R/h.
template <int d, class Sum>
void add(const std::string& sums, Evaluation evaluation, const std::vector<std::int64_t>& radii,
         benchmark::BigO growth) {
  auto* const row = benchmark::RegisterBenchmark(
      fmt::format("invariant/{}d/{}/{}", d, sums, to_string(evaluation)).c_str(),
      [evaluation](benchmark::State& state) { invariant<d, Sum>(state, evaluation); });
  row->ArgName("R")->Unit(benchmark::kMillisecond)->Complexity(growth);
  for (const std::int64_t R : radii) row->Arg(R);
}

}  // namespace
}  // namespace gridstep

int main(int argc, char** argv) {
  using namespace gridstep;
  using enum Evaluation;
  using namespace benchmark;
  add<3, PlainSum<3, std::int64_t>>("count", full, {5, 10, 20, 40}, oNCubed);
  add<3, PlainSum<3, std::int64_t>>("count", masks, {5, 10, 20, 40}, oNSquared);
  add<3, MomentSums<3, std::int64_t>>("moments", full, {5, 10, 20}, oNCubed);
  add<3, MomentSums<3, std::int64_t>>("moments", masks, {5, 10, 20}, oNSquared);
  add<2, PlainSum<2, std::int64_t>>("count", full, {20, 90, 171}, oNSquared);
  add<2, PlainSum<2, std::int64_t>>("count", masks, {20, 90, 171}, oN);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
