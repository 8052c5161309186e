// Every 2D estimator that works on contours, one thread, whole contours of n linels: contour/<estimator>/n:<n> on the
// flower 20 + 10 cos(6 t + 3), contour/<estimator>/disk/n:<n> on a disk of radius 1. Before it is timed, its values are
// compared with those of the same contour read from another linel.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>

#include "estimators/catalogue.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/scene.hpp"

namespace gridstep {
namespace {

struct Contour {
  std::string shape;
  double h;
  std::size_t n;  ///< linels that it is known to have: benchmarks are named before anything is digitized
};

const Scene<2>& scene(const Contour& contour) {
  static std::map<std::pair<std::string, double>, Scene<2>> known;
  const auto key = std::pair(contour.shape, contour.h);
  auto found = known.find(key);
  if (found == known.end()) {
    SceneSettings<2> settings;
    settings.h = {contour.h};
    settings.placement.shift = {0.13, 0.37};
    const auto shape = std::get<std::shared_ptr<const Shape<2>>>(make_shape(ShapeSpec::parse(contour.shape)));
    found = known.emplace(key, make_scene<2>(*shape, settings)).first;
  }
  return found->second;
}

bool same_from_another_start(Estimator<2>& estimator, std::vector<Surfel<2>> linels) {
  const Estimates values = estimator.eval(linels);
  const std::size_t turn = linels.size() / 3;
  std::rotate(linels.begin(), linels.begin() + std::ptrdiff_t(turn), linels.end());
  const Estimates turned = estimator.eval(linels);
  for (std::size_t c = 0; c < values.columns.size(); ++c)
    for (std::size_t i = 0; i < linels.size(); ++i) {
      const double a = turned.columns[c][i], b = values.columns[c][(i + turn) % linels.size()];
      if (!(std::abs(a - b) <= 1e-9 * (1 + std::abs(b)))) return false;
    }
  return true;
}

void evaluate(benchmark::State& state, const std::string& name, const Contour& contour) {
  const Scene<2>& on = scene(contour);
  if (on.surfels.size() != contour.n) {
    state.SkipWithError("the contour has another number of linels");
    return;
  }
  const auto estimator = find_estimator(name).variant<2>().make(on.set, {});
  estimator->init({contour.h}, {0});
  if (!same_from_another_start(*estimator, on.surfels)) {
    state.SkipWithError("the values depend on where the contour starts");
    return;
  }
  const std::clock_t start = std::clock();
  for (auto _ : state) benchmark::DoNotOptimize(estimator->eval(on.surfels));
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  state.counters["ns_per_surfel"] = 1e9 * seconds / (double(state.iterations()) * double(contour.n));
}

}  // namespace
}  // namespace gridstep

int main(int argc, char** argv) {
  using namespace gridstep;
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const std::string flower = "flower:radius=20,amplitude=10,petals=6,phase=3", disk = "disk:radius=1";
  // A digitized disk is one arc: what looks at arcs must not become quadratic there.
  const std::vector<Contour> contours{{flower, 0.0993, 3600},
                                      {flower, 0.012501, 28600},
                                      {disk, 8e-4, 10'000},
                                      {disk, 8e-5, 100'000},
                                      {disk, 8e-6, 1'000'000}};
  for (const EstimatorEntry& entry : estimator_catalogue()) {
    if (!entry.in_2d || entry.in_2d->takes_radius) continue;
    for (const Contour& contour : contours) {
      if (entry.name == "ii-parameter-free" && contour.shape == disk) continue;  // minutes
      benchmark::RegisterBenchmark(
          fmt::format("contour/{}/{}n:{}", entry.name, contour.shape == disk ? "disk/" : "", contour.n)
              .c_str(),
          [name = entry.name, contour](benchmark::State& state) { evaluate(state, name, contour); })
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
