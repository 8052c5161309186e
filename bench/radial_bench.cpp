// Radial kernels over a surface: evaluation alone, on one thread. Names are radial/3d/ii-ho1/<what>/<strategy>/R:<R/h>; `mean`
// is mean curvature and nothing else, `all` everything that the estimator has.
//
// `ns_per_surfel` is processor time in the quickest iteration; `bricks` is compared with `full` on a sample of the surfels
// before it is timed.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <map>

#include "estimators/catalogue.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

struct Surface {
  DigitalSet<3> set;
  std::vector<Surfel<3>> surfels;
};

/// Goursat's surface at the grid step at which R = 6.75 h^1/3, the usual radius, is R/h cells.
const Surface& surface(double R) {
  static std::map<double, Surface> known;
  auto found = known.find(R);
  if (found == known.end()) {
    DigitalSet<3> set = gauss_digitize<3>(*make_shape<3>("goursat"), {std::pow(6.75 / R, 1.5)});
    std::vector<Surfel<3>> surfels = boundary(set);
    found = known.emplace(R, Surface{std::move(set), std::move(surfels)}).first;
  }
  return found->second;
}

std::unique_ptr<Estimator<3>> estimator(const Surface& on, Evaluation evaluation, const std::string& only,
                                        double R) {
  auto result = find_estimator("ii-ho1").variant<3>().make(on.set, {evaluation, KernelCentre::surfel, only});
  result->init({1}, {R});
  return result;
}

bool equals_full(Estimator<3>& own, const Surface& on, const std::string& only, double R) {
  std::vector<Surfel<3>> sample;
  for (std::size_t i = 0; i < on.surfels.size(); i += on.surfels.size() / 50 + 1)
    sample.push_back(on.surfels[i]);
  return own.eval(sample).columns == estimator(on, Evaluation::full, only, R)->eval(sample).columns;
}

void radial(benchmark::State& state, Evaluation evaluation, const std::string& only) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const double R = double(state.range(0));
  const Surface& on = surface(R);
  const std::size_t affordable =
      evaluation == Evaluation::full ? std::size_t(3e9 / (R * R * R)) : on.surfels.size();
  const std::span surfels(on.surfels.data(), std::min(on.surfels.size(), affordable));
  const auto own = estimator(on, evaluation, only, R);
  if (evaluation != Evaluation::full && !equals_full(*own, on, only, R)) {
    state.SkipWithError("differs from the full kernel");
    return;
  }
  double seconds = std::numeric_limits<double>::infinity();
  for (auto _ : state) {
    const std::clock_t begin = std::clock();
    benchmark::DoNotOptimize(own->eval(surfels));
    seconds = std::min(seconds, double(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  state.counters["surfels"] = double(surfels.size());
  state.counters["ns_per_surfel"] = 1e9 * seconds / double(surfels.size());
  state.counters["cells_visited"] = double(own->work().cells_visited);
}

void add(const std::string& what, const std::string& only) {
  for (const Evaluation evaluation : {Evaluation::full, Evaluation::bricks}) {
    auto* const rows =
        benchmark::RegisterBenchmark(("radial/3d/ii-ho1/" + what + "/" + to_string(evaluation)).c_str(),
                                     [=](benchmark::State& state) { radial(state, evaluation, only); });
    rows->ArgName("R")->Unit(benchmark::kMillisecond);
    for (const int R : {13, 27, 54})
      if (evaluation != Evaluation::full || R < 54) rows->Arg(R);
  }
}

}  // namespace
}  // namespace gridstep

int main(int argc, char** argv) {
  gridstep::add("mean", "mean");
  gridstep::add("all", "");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
