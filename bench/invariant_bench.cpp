// Integral invariants over whole surfaces, one thread: evaluation alone, after init() and with the surfels at
// hand. Names are invariant/<dimension>/<sums>/<strategy>/R:<R/h>; every strategy is compared with `full`, on all
// surfels or on a sample of them, before it is timed.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>
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

/// Part of the boundary of a ball of radius 5 at the grid step for which R = 3 h^1/3 is R/h cells, as in studies: the
/// geometry that decides how many cells the kernel's boundary crosses changes with R/h. The part is large enough for
/// kernels to be mostly shared, and small enough for the slower strategies.
template <int d>
const Surface<d>& surface(double R) {
  static std::map<double, Surface<d>> known;
  auto found = known.find(R);
  if (found == known.end()) {
    DigitalSet<d> set = gauss_digitize<d>(OffCentreBall<d>(5 * std::pow(R / 3, 1.5)), {1});
    std::vector<Surfel<d>> surfels = boundary(set);
    constexpr std::size_t kMost = 150'000;
    if (surfels.size() > kMost) {
      // Neither a pole nor an equator.
      const auto first = surfels.begin() + std::ptrdiff_t(surfels.size() / 5);
      surfels = {first, std::min(surfels.end(), first + kMost)};
    }
    found = known.emplace(R, Surface<d>{std::move(set), std::move(surfels)}).first;
  }
  return found->second;
}

template <int d, class Sum>
using Pairs = std::vector<typename SurfelSums<d, Sum>::Pair>;

/// As many surfels, evenly spread, as the whole kernel is quickly evaluated at.
template <int d, class Sum>
struct Sample {
  std::size_t stride;
  Pairs<d, Sum> expected;
};
template <int d, class Sum>
const Sample<d, Sum>& reference(double R) {
  static std::map<double, Sample<d, Sum>> known;
  auto found = known.find(R);
  if (found == known.end()) {
    const auto& [set, all] = surface<d>(R);
    SurfelSums<d, Sum> sums(set, {Evaluation::full, KernelCentre::spels});
    sums.init({1}, {R});
    const auto most = std::size_t(2e9 / double(sums.work().kernel_size));
    const std::size_t stride = all.size() / most + 1;
    std::vector<Surfel<d>> surfels;
    for (std::size_t i = 0; i < all.size(); i += stride) surfels.push_back(all[i]);
    found = known.emplace(R, Sample<d, Sum>{stride, sums.eval(surfels)}).first;
  }
  return found->second;
}

template <int d, class Sum>
void invariant(benchmark::State& state, Evaluation evaluation) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const double R = double(state.range(0));
  const auto& [set, surfels] = surface<d>(R);
  SurfelSums<d, Sum> sums(set, {evaluation, KernelCentre::spels});
  sums.init({1}, {R});
  if (evaluation != Evaluation::full) {
    const Pairs<d, Sum> own = sums.eval(surfels);
    const auto& [stride, expected] = reference<d, Sum>(R);
    for (std::size_t i = 0; i < expected.size(); ++i)
      if (!(own[i * stride].inner == expected[i].inner && own[i * stride].outer == expected[i].outer)) {
        state.SkipWithError("differs from the full kernel");
        return;
      }
  }
  const std::clock_t begin = std::clock();  // of the process, which has one thread
  for (auto _ : state) benchmark::DoNotOptimize(sums.eval(surfels));
  const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
  const double ns = 1e9 * seconds / (double(state.iterations()) * double(surfels.size()));
  state.SetComplexityN(state.range(0));
  state.counters["ns_per_surfel"] = ns;
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
  using Count2 = PlainSum<2, std::int64_t>;
  using Count3 = PlainSum<3, std::int64_t>;
  using Moments3 = MomentSums<3, std::int64_t>;
  add<3, Count3>("count", full, {5, 10, 20}, oNCubed);
  add<3, Count3>("count", masks, {5, 10, 20, 40, 80}, oNSquared);
  add<3, Count3>("count", bricks, {5, 10, 20, 40, 80, 160}, oN);
  add<3, Moments3>("moments", full, {5, 10, 20}, oNCubed);
  add<3, Moments3>("moments", masks, {5, 10, 20, 40, 80}, oNSquared);
  add<3, Moments3>("moments", bricks, {5, 10, 20, 40, 80, 160}, oN);
  add<2, Count2>("count", full, {20, 90, 171}, oNSquared);
  add<2, Count2>("count", masks, {20, 90, 171, 500}, oN);
  add<2, Count2>("count", bricks, {20, 90, 171, 500, 2000}, oLogN);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
