// What precedes an evaluation: digitization, extraction of the boundary and of its components, and a kernel with its
// displacement masks. Names are <work>/<dimension>/<shape>/h:<step>, on one thread unless they end in threads:2.
//
// Digitization and extraction are compared with the plain definition, at a coarse step, before they are timed; what
// runs on two threads is compared with what one thread finds.

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

double seconds(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Times work() by the surfel: the processor for one thread, the clock on the wall for more.
template <class Work>
void run(benchmark::State& state, std::size_t surfels, Work work) {
  const bool one_thread =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1;
  const clockid_t clock = one_thread ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
  const double begin = seconds(clock);
  for (auto _ : state) benchmark::DoNotOptimize(work());
  const double each = (seconds(clock) - begin) / double(state.iterations());
  state.counters["ns_per_surfel"] = 1e9 * each / double(surfels);
  state.counters["surfels"] = double(surfels);
}

template <int d>
void digitize(benchmark::State& state, const Shape<d>& shape, GridStep h,
              const std::vector<Surfel<d>>& expected) {
  DigitizationWork work;
  const DigitalSet<d> set = gauss_digitize<d>(shape, h, &work);
  if (boundary(set) != expected) return state.SkipWithError("differs from one thread");
  run(state, expected.size(), [&] { return gauss_digitize<d>(shape, h); });
  const double surfels = double(expected.size());
  state.counters["predicate_calls_per_surfel"] = double(work.points + work.boxes) / surfels;
  state.counters["bytes_per_surfel"] = double(set.memory()) / surfels;
  state.counters["points_sampled"] = double(work.points);
  state.counters["boxes"] = double(work.boxes);
}

template <int d>
void extract(benchmark::State& state, const Shape<d>& shape, GridStep h,
             const std::vector<Surfel<d>>& expected) {
  const DigitalSet<d> set = gauss_digitize<d>(shape, h);
  if (boundary(set) != expected) return state.SkipWithError("differs from one thread");
  run(state, expected.size(), [&] { return boundary(set); });
}

template <int d>
void extract_in_chunks(benchmark::State& state, const Shape<d>& shape, GridStep h,
                       const std::vector<Surfel<d>>& expected) {
  const DigitalSet<d> set = gauss_digitize<d>(shape, h);
  constexpr std::size_t kMost = 1 << 16;
  std::vector<Surfel<d>> all;
  for_each_boundary_chunk<d>(set, kMost,
                             [&](auto chunk) { all.insert(all.end(), chunk.begin(), chunk.end()); });
  if (all != expected) return state.SkipWithError("differs from the boundary as a whole");
  run(state, expected.size(), [&] {
    std::size_t count = 0;
    for_each_boundary_chunk<d>(set, kMost, [&](auto chunk) { count += chunk.size(); });
    return count;
  });
}

template <int d>
void connect(benchmark::State& state, const Shape<d>& shape, GridStep h,
             const std::vector<Surfel<d>>& expected) {
  const DigitalSet<d> set = gauss_digitize<d>(shape, h);
  if (connected_boundary(set).surfels.size() != expected.size()) return state.SkipWithError("loses surfels");
  run(state, expected.size(), [&] { return connected_boundary(set); });
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
using Task = void(benchmark::State&, const Shape<d>&, GridStep, const std::vector<Surfel<d>>&);

template <int d>
void add(const std::string& work, Task<d>* task, const std::string& spec, double coarse, double h,
         int threads) {
  const std::string name = fmt::format("{}/{}d/{}/h:{}{}", work, d, spec, h,
                                       threads > 1 ? fmt::format("/threads:{}", threads) : "");
  auto* const row = benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    const auto shape = make_shape<d>(spec);
    if (!equals_the_definition<d>(*shape, {coarse}))
      return state.SkipWithError("differs from looking at every point");
    const auto limited = [](int most) {
      return tbb::global_control(tbb::global_control::max_allowed_parallelism, std::size_t(most));
    };
    std::vector<Surfel<d>> expected;
    {
      const auto one_thread = limited(1);
      expected = boundary(gauss_digitize<d>(*shape, {h}));
    }
    const auto these_threads = limited(threads);
    task(state, *shape, {h}, expected);
  });
  row->Unit(benchmark::kMillisecond);
  if (threads > 1) row->UseRealTime();
}

/// Digitization and extraction at some steps; at the finest, all there is.
template <int d>
void add_all(const std::string& spec, const std::vector<double>& steps) {
  const double coarse = 8 * steps.front();
  for (const double h : steps) {
    add<d>("digitize", digitize<d>, spec, coarse, h, 1);
    add<d>("extract", extract<d>, spec, coarse, h, 1);
  }
  const double h = steps.back();
  add<d>("digitize", digitize<d>, spec, coarse, h, 2);
  add<d>("extract", extract<d>, spec, coarse, h, 2);
  add<d>("extract-chunks", extract_in_chunks<d>, spec, coarse, h, 1);
  add<d>("connect", connect<d>, spec, coarse, h, 1);
}

}  // namespace
}  // namespace gridstep

int main(int argc, char** argv) {
  using namespace gridstep;
  add_all<3>("sphere", {0.08, 0.04, 0.02});
  add_all<3>("torus", {0.08, 0.04, 0.02});
  add_all<3>("goursat", {0.2, 0.1, 0.05});
  add_all<3>("rounded-cube", {0.2, 0.1, 0.05});
  add_all<3>("leopold", {0.1, 0.05, 0.025});
  add_all<3>("heart", {0.02, 0.01, 0.005});
  add_all<3>("distel", {0.2, 0.1, 0.05});
  add_all<2>("disk", {0.01, 0.001});
  add_all<2>("ellipse", {0.01, 0.001});
  add_all<2>("flower", {0.01, 0.001});
  add_all<2>("accflower", {0.01, 0.001});
  add_all<2>("lemniscate", {0.01, 0.001});
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
