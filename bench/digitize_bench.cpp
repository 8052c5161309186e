// What precedes an evaluation: digitization, extraction of the boundary, and a kernel with its displacement
// masks. One thread. Both fast paths are compared with the plain definition, at a coarse step, before they
// are timed.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <ctime>

#include "estimators/integral_invariant/kernel.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

/// Whether digitization and boundary are those of sampling every point and looking at every neighbour.
template <int d>
bool equals_the_definition(const Shape<d>& shape, GridStep h) {
  const DigitalSet<d> set = gauss_digitize<d>(shape, h);
  std::size_t surfels = 0;
  bool same = true;
  for_each_point(set.domain(), [&](const LatticePoint<d>& z) {
    const bool inside = set.contains(z);
    same = same && inside == shape.contains(h.value * z.template cast<double>());
    for (int axis = 0; inside && axis < d; ++axis)
      for (const int sign : {-1, +1})
        surfels += !set.contains(Surfel<d>{z, std::int8_t(axis), std::int8_t(sign)}.outer());
  });
  return same && surfels == boundary(set).size();
}

/// Runs the loop, and counts the time of a surfel.
template <int d, class Work>
void run(benchmark::State& state, const DigitalSet<d>& set, Work work) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const std::size_t surfels = boundary(set).size();
  const std::clock_t begin = std::clock();  // of the process, which has one thread
  for (auto _ : state) benchmark::DoNotOptimize(work());
  const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
  state.counters["ns_per_surfel"] = 1e9 * seconds / (double(state.iterations()) * double(surfels));
  state.counters["surfels"] = double(surfels);
  state.SetComplexityN(state.range(0));
}

template <int d>
void digitize(benchmark::State& state, const std::string& spec, GridStep coarse) {
  const auto shape = make_shape<d>(spec);
  if (!equals_the_definition<d>(*shape, coarse)) {
    state.SkipWithError("differs from sampling every point");
    return;
  }
  const GridStep h{1.0 / double(state.range(0))};
  DigitizationWork work;
  const DigitalSet<d> set = gauss_digitize<d>(*shape, h);
  run(state, set, [&] { return gauss_digitize<d>(*shape, h, &work); });
  state.counters["calls_per_surfel"] = double(work.points + work.boxes) / state.counters["surfels"];
  state.counters["points_sampled"] = double(work.points);
  state.counters["boxes"] = double(work.boxes);
  state.counters["memory"] = double(set.memory());
}

template <int d>
void extract(benchmark::State& state, const std::string& spec) {
  const DigitalSet<d> set = gauss_digitize<d>(*make_shape<d>(spec), {1.0 / double(state.range(0))});
  run(state, set, [&] { return boundary(set); });
}

template <int d>
void kernel(benchmark::State& state) {
  const double R = double(state.range(0));
  std::size_t size = 0;
  for (auto _ : state) {
    const auto ball = ball_kernel<d>({R});
    const DisplacementMasks<d, std::int64_t> masks(ball);
    benchmark::DoNotOptimize(&masks);
    size = ball.size();
  }
  state.counters["kernel_size"] = double(size);
  state.SetComplexityN(state.range(0));
}

template <int d>
void add(const std::string& spec, const std::vector<std::int64_t>& inverse_steps) {
  const GridStep coarse{2.0 / double(inverse_steps.front())};
  const auto growth = d == 2 ? benchmark::oN : benchmark::oNSquared;  // that of the surface in 1/h
  auto* const digitization = benchmark::RegisterBenchmark(
      fmt::format("digitize/{}d/{}", d, spec).c_str(),
      [spec, coarse](benchmark::State& state) { digitize<d>(state, spec, coarse); });
  auto* const extraction =
      benchmark::RegisterBenchmark(fmt::format("boundary/{}d/{}", d, spec).c_str(),
                                   [spec](benchmark::State& state) { extract<d>(state, spec); });
  for (auto* const row : {digitization, extraction}) {
    row->ArgName("inv_h")->Unit(benchmark::kMillisecond)->Complexity(growth);
    for (const std::int64_t n : inverse_steps) row->Arg(n);
  }
}

}  // namespace
}  // namespace gridstep

int main(int argc, char** argv) {
  using namespace gridstep;
  add<3>("sphere", {4, 8, 16});
  add<3>("torus", {10, 20, 50});
  add<3>("goursat", {4, 8, 16});
  add<3>("rounded-cube", {4, 8, 16});
  add<3>("leopold", {8, 16, 32});
  add<3>("heart", {60, 120, 240});
  add<2>("disk", {40, 160, 640});
  add<2>("flower", {10, 40, 160});
  add<2>("accflower", {10, 40, 160});
  add<2>("lemniscate", {40, 160, 640});
  const auto kernels = [](auto* const row, benchmark::BigO growth, std::vector<std::int64_t> radii) {
    row->ArgName("R")->Unit(benchmark::kMillisecond)->Complexity(growth);
    for (const std::int64_t R : radii) row->Arg(R);
  };
  kernels(benchmark::RegisterBenchmark("kernel/3d", kernel<3>), benchmark::oNCubed, {5, 10, 20, 40});
  kernels(benchmark::RegisterBenchmark("kernel/2d", kernel<2>), benchmark::oNSquared, {20, 90, 171});
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
