// A whole study: digitization, truth, evaluation and records of a few levels and shifts, on all threads. Sums by bricks are
// compared with those of the full kernel, or of the masks, inside the study: run_study() throws where they differ.

#include <benchmark/benchmark.h>

#include <exception>
#include <nlohmann/json.hpp>

#include "experiments/runner.hpp"

namespace gridstep {
namespace {

const char* const kFlat = R"json({
  "name": "flat",
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7", "flower:radius=20,amplitude=7,petals=6"], "estimators": ["ii"],
    "evaluations": ["bricks", "full"], "radii": [{"k": 5}],
    "schedule": {"from": 1, "to": 0.1, "steps": 4}, "shifts": 2}]
})json";

const char* const kSolid = R"json({
  "name": "solid",
  "sweeps": [{
    "shapes": ["torus:major=6,minor=2", "goursat"], "estimators": ["ii", "ii-covariance"],
    "evaluations": ["bricks", "masks"], "radii": [{"k": 3}],
    "schedule": {"from": 1, "to": 0.25, "steps": 3}, "shifts": 2}]
})json";

void study(benchmark::State& state, const char* text) {
  const nlohmann::json json = nlohmann::json::parse(text);
  const Study study = Study::read(json, "study_bench.cpp");
  double surfels = 0, cells = 0;
  try {
    for (auto _ : state) {
      surfels = cells = 0;
      for (const Record& record : run_study(study, json, {})) {
        surfels += double(record.surfels);
        cells += double(record.work.cells_visited);
      }
    }
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
    return;
  }
  state.counters["surfels"] = surfels;
  state.counters["cells_visited"] = cells;
  state.counters["surfels_per_second"] =
      benchmark::Counter(surfels * double(state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(study, flat, kFlat)->Name("study/2d")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(study, solid, kSolid)->Name("study/3d")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace gridstep

BENCHMARK_MAIN();
