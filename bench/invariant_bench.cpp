// Integral invariants over surfaces and contours: evaluation alone, after init() and with the surfels at hand. Names
// are invariant/<dimension>/<sums>/<strategy>/R:<R/h>, on one thread; `bricks` has rows for two threads and for each
// lesser instruction set too.
//
// `ns_per_surfel` is processor time, of all threads, in the quickest iteration: a busy machine only adds to it. `growth`
// is the power of R/h fitted to it, on this row and those with smaller R/h. Every strategy is compared with `full`, on
// all surfels or on a sample of them, before it is timed.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <map>

#include "bench/heap_use.hpp"
#include "estimators/integral_invariant/bricks/targets.hpp"
#include "estimators/integral_invariant/surfel_sums.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {
namespace {

/// Part of a digital boundary, or all of it.
template <int d>
struct Surface {
  DigitalSet<d> set;
  std::vector<Surfel<d>> surfels;
  std::size_t of;  ///< surfels of the whole boundary
};

/// A sphere of radius 5, or the flower 20 + 10 cos(6 t + 3), at the grid step h at which R = 3 h^1/3 is R/h cells, as in
/// studies: how many cells the kernel's boundary crosses near the shape's depends on both. Of more than two million
/// surfels, as many in one piece, neither at a pole nor at the equator.
template <int d>
const Surface<d>& surface(double R) {
  static std::map<double, Surface<d>> known;
  auto found = known.find(R);
  if (found == known.end()) {
    const auto shape =
        make_shape<d>(d == 2 ? "flower:radius=20,amplitude=10,petals=6,phase=3" : "sphere:radius=5");
    DigitalSet<d> set = gauss_digitize<d>(*shape, {std::pow(3 / R, 1.5)});
    std::vector<Surfel<d>> surfels = boundary(set);
    const std::size_t of = surfels.size(), most = 2'000'000;
    if (of > most) {
      const auto first = surfels.begin() + std::ptrdiff_t(of / 5);
      surfels = std::vector(first, first + most);
    }
    found = known.emplace(R, Surface<d>{std::move(set), std::move(surfels), of}).first;
  }
  return found->second;
}

/// At a surfel's inner and outer spel.
template <class Sum>
using Pairs = std::vector<std::pair<Sum, Sum>>;

template <int d, class Sum>
Pairs<Sum> pairs(SurfelSums<d, Sum>& sums, std::span<const Surfel<d>> surfels) {
  Pairs<Sum> result(surfels.size());
  sums.eval(surfels, [&](std::size_t i, const Sum& inner, const Sum& outer) { result[i] = {inner, outer}; });
  return result;
}

/// What `full` gives at every stride-th surfel.
template <class Sum>
struct Sample {
  std::size_t stride;
  Pairs<Sum> expected;
};

template <int d, class Sum>
const Sample<Sum>& sample(double R) {
  static std::map<double, Sample<Sum>> known;
  auto found = known.find(R);
  if (found == known.end()) {
    const Surface<d>& on = surface<d>(R);
    SurfelSums<d, Sum> sums(on.set, {Evaluation::full, KernelCentre::spels});
    sums.init({1}, {R});
    const std::size_t stride = on.surfels.size() * std::size_t(sums.work().kernel_size) / 300'000'000 + 1;
    std::vector<Surfel<d>> surfels;
    for (std::size_t i = 0; i < on.surfels.size(); i += stride) surfels.push_back(on.surfels[i]);
    found = known.emplace(R, Sample<Sum>{stride, pairs<d, Sum>(sums, surfels)}).first;
  }
  return found->second;
}

template <int d, class Sum>
bool equals_full(const Pairs<Sum>& own, double R) {
  const auto& [stride, expected] = sample<d, Sum>(R);
  for (std::size_t i = 0; i * stride < own.size(); ++i)
    if (own[i * stride] != expected[i]) return false;
  return true;
}

/// Surfels that a strategy gets through in a few seconds.
template <int d, class Sum>
std::size_t affordable(double R, Evaluation evaluation) {
  const double cells = evaluation == Evaluation::full    ? 4 * std::pow(R, d)
                       : evaluation == Evaluation::masks ? 6 * std::pow(R, d - 1)
                                                         : 10 * std::pow(R, d - 2);
  const double cost = evaluation == Evaluation::bricks && sizeof(Sum) > 8 ? 6 : 1;
  return std::size_t(4e9 / (cells * cost));
}

/// The slope of log y against log x, by least squares.
double fitted_power(const std::map<double, double>& y_of_x) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [a, b] : y_of_x) {
    x += std::log(a);
    y += std::log(b);
    xx += std::log(a) * std::log(a);
    xy += std::log(a) * std::log(b);
  }
  const auto n = double(y_of_x.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

struct Row {
  Evaluation evaluation;
  std::string target = "";  ///< of bricks; empty: the one that programs take
  std::size_t threads = 1;
};

template <int d, class Sum>
void invariant(benchmark::State& state, const Row& row, std::map<double, double>& times) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, row.threads);
  static const std::string usual = bricks::target().name;
  bricks::use_target(row.target.empty() ? usual : row.target);
  const double R = double(state.range(0));
  const Surface<d>& on = surface<d>(R);
  const std::span<const Surfel<d>> surfels(on.surfels.data(),
                                           std::min(on.surfels.size(), affordable<d, Sum>(R, row.evaluation)));
  const auto n = double(surfels.size());
  SurfelSums<d, Sum> sums(on.set, {row.evaluation, KernelCentre::spels});
  const std::int64_t before = heap::bytes;
  sums.init({1}, {R});
  const std::int64_t after = heap::peak = heap::bytes.load();
  {
    const Pairs<Sum> own = pairs<d, Sum>(sums, surfels);
    const double held = double(heap::peak - after) - double(own.size() * sizeof(own[0]));
    state.counters["bytes_per_surfel"] = double(on.set.memory()) / double(on.of) + held / n;
    state.counters["table_bytes"] = double(after - before);
    if (row.evaluation != Evaluation::full && !equals_full<d, Sum>(own, R)) {
      state.SkipWithError("differs from the full kernel");
      return;
    }
  }
  double seconds = std::numeric_limits<double>::infinity();
  for (auto _ : state) {
    const std::clock_t begin = std::clock();
    sums.eval(surfels, [](std::size_t, const Sum& inner, const Sum& outer) {
      benchmark::DoNotOptimize(inner.n + outer.n);
    });
    seconds = std::min(seconds, double(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  times[R] = 1e9 * seconds / n;
  state.counters["ns_per_surfel"] = times[R];
  if (times.size() > 1) state.counters["growth"] = fitted_power(times);
  state.counters["surfels"] = n;
  state.counters["cells_visited"] = double(sums.work().cells_visited);
  state.counters["restarts"] = double(sums.work().restarts);
}

template <int d, class Sum>
void add(const std::string& sums, const Row& row, const std::vector<std::int64_t>& radii) {
  std::string name = fmt::format("invariant/{}d/{}/{}", d, sums, to_string(row.evaluation));
  if (!row.target.empty()) name += "/" + row.target;
  if (row.threads > 1) name += fmt::format("/threads:{}", row.threads);
  auto* const family = benchmark::RegisterBenchmark(
      name.c_str(), [row, times = std::map<double, double>()](benchmark::State& state) mutable {
        invariant<d, Sum>(state, row, times);
      });
  family->ArgName("R")->Unit(benchmark::kMillisecond);
  for (const std::int64_t R : radii) family->Arg(R);
}

}  // namespace
}  // namespace gridstep

int main(int argc, char** argv) {
  using namespace gridstep;
  using enum Evaluation;
  using Count2 = PlainSum<2, std::int64_t>;
  using Count3 = PlainSum<3, std::int64_t>;
  using Moments2 = MomentSums<2, std::int64_t>;
  using Moments3 = MomentSums<3, std::int64_t>;
  add<3, Count3>("count", {full}, {5, 10, 20});
  add<3, Count3>("count", {masks}, {5, 10, 20, 40, 80});
  add<3, Count3>("count", {bricks}, {10, 20, 40, 80, 160});
  add<3, Count3>("count", {bricks, "", 2}, {40});
  add<3, Moments3>("moments", {full}, {5, 10, 20});
  add<3, Moments3>("moments", {masks}, {5, 10, 20, 40, 80});
  add<3, Moments3>("moments", {bricks}, {10, 20, 40, 80, 160});
  add<2, Count2>("count", {full}, {20, 90, 171});
  add<2, Count2>("count", {masks}, {20, 90, 171, 500});
  add<2, Count2>("count", {bricks}, {20, 90, 171, 500, 2000});
  add<2, Moments2>("moments", {full}, {20, 90, 171});
  add<2, Moments2>("moments", {masks}, {20, 90, 171, 500});
  add<2, Moments2>("moments", {bricks}, {20, 90, 171, 500, 2000});
  const std::vector<bricks::Target>& targets = bricks::targets();
  for (std::size_t i = 1; i < targets.size(); ++i) {
    add<3, Count3>("count", {bricks, targets[i].name}, {20, 40});
    add<3, Moments3>("moments", {bricks, targets[i].name}, {20, 40});
    add<2, Count2>("count", {bricks, targets[i].name}, {171});
    add<2, Moments2>("moments", {bricks, targets[i].name}, {171});
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
