#include "experiments/runner.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/compared.hpp"
#include "experiments/core/build_info.hpp"
#include "experiments/core/journal.hpp"
#include "experiments/core/progress.hpp"
#include "experiments/memory.hpp"
#include "shapes/base/contracts.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One digitization of a sweep: a shape, a noise, a level and a shift.
struct Job {
  const Sweep* sweep;
  std::size_t shape, noise, level;
  int shift;
};

std::vector<Job> jobs_of(const Study& study) {
  std::vector<Job> jobs;
  for (const Sweep& sweep : study.sweeps)
    for (std::size_t shape = 0; shape < sweep.shapes.size(); ++shape)
      for (std::size_t noise = 0; noise < sweep.noise.size(); ++noise)
        for (std::size_t level = 0; level < sweep.schedule.values().size(); ++level)
          for (int shift = 0; shift < sweep.shifts; ++shift)
            jobs.push_back({&sweep, shape, noise, level, shift});
  return jobs;
}

/// By how many powers of R/h an evaluation reads less than the whole kernel.
int steps_saved(Evaluation evaluation) {
  return evaluation == Evaluation::full ? 0 : evaluation == Evaluation::masks ? 1 : 2;
}

/// Proportional to the expected time: cells read at every surfel of the bounding box.
template <int d>
double work_of(const Sweep& sweep, const Shape<d>& shape, GridStep h) {
  const double surfels = std::pow(shape.size() / h.value, d - 1);
  double reads = 300;  // digitization and truth
  for (const Method& method : sweep.methods())
    reads += method.radius
                 ? std::pow(to_digital(method.radius->at(h), h).value, d - steps_saved(*method.evaluation))
                 : 300;
  return surfels * reads;
}

/// Evaluates on one thread, several times where that is quick, and returns the shortest time.
template <class Function>
double timed(bool alone, Function evaluate) {
  const auto once = [&] {
    const auto start = std::chrono::steady_clock::now();
    evaluate();
    return seconds_since(start);
  };
  if (!alone) return once();
  tbb::task_arena one_thread(1);
  double best = std::numeric_limits<double>::infinity(), total = 0;
  for (int i = 0; i < 5 && total < 0.1; ++i) {
    const double seconds = one_thread.execute(once);
    best = std::min(best, seconds);
    total += seconds;
  }
  return best;
}

/// The truth where the values of some estimators of a sweep belong.
struct TruthAt {
  Truth truth;
  double seconds;
};

template <int d>
std::map<ValuePosition, TruthAt> truths_of(const Sweep& sweep, const Shape<d>& shape, const Scene<d>& scene) {
  std::map<ValuePosition, std::vector<std::string>> columns;
  for (const std::string& estimator : sweep.estimators) {
    const auto& variant = find_estimator(estimator).variant<d>();
    std::vector<std::string>& names = columns[variant.position];
    for (const Compared& compared : compared_quantities(variant))
      for (const std::string& name : compared.columns)
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::map<ValuePosition, TruthAt> truths;
  for (const auto& [position, names] : columns) {
    const auto start = std::chrono::steady_clock::now();
    const GridStep h = scene.settings.h;
    Truth truth = truth_at<d>(shape, scene.settings, value_points<d>(position, scene.surfels, h),
                              farthest_from_boundary(position, h), names);
    truths[position] = {std::move(truth), seconds_since(start)};
  }
  return truths;
}

template <int d>
std::vector<Record> run_job(const Study& study, const Job& job, const Shape<d>& shape) {
  const Sweep& sweep = *job.sweep;
  const GridStep h{sweep.schedule.values()[job.level]};
  SceneSettings<d> settings;
  settings.h = h;
  RandomStream random{study.seed, job.level, std::uint64_t(job.shift)};
  settings.placement.shift = random_shift<d>(random);
  if (sweep.rotate) settings.placement.rotation = random_rotation<d>(random);
  settings.noise = sweep.noise[job.noise];
  settings.noise_seed = random.bits();

  const auto start = std::chrono::steady_clock::now();
  const Scene<d> scene = make_scene<d>(shape, settings);
  Record common;
  common.seconds_digitize = seconds_since(start);

  common.shape = sweep.shapes[job.shape].canonical();
  common.dimension = d;
  common.h = h.value;
  common.noise = settings.noise;
  common.rotated = sweep.rotate;
  common.shift = job.shift;
  common.offset.assign(settings.placement.shift.begin(), settings.placement.shift.end());
  common.surfels = std::int64_t(scene.surfels.size());
  common.components = std::int64_t(scene.components);

  const std::map<ValuePosition, TruthAt> truths = truths_of(sweep, shape, scene);
  std::vector<Record> records;
  std::optional<Estimates> first_sums;  // of the method's estimator and radius
  for (const Method& method : sweep.methods()) {
    const auto& variant = find_estimator(method.estimator).variant<d>();
    const auto& [truth, seconds_truth] = truths.at(variant.position);
    Record record = common;
    record.estimator = method.estimator;
    record.singular = truth.singular;
    record.far = truth.far;
    record.worst_residual = truth.worst_residual;
    record.seconds_truth = seconds_truth;
    EuclideanLength R{0};
    if (method.radius) {
      R = method.radius->at(h);
      record.evaluation = to_string(*method.evaluation);
      record.centre = sweep.centre == KernelCentre::spels ? "spels" : "surfel";
      record.k = method.radius->k;
      record.alpha = method.radius->alpha;
      record.digital_radius = to_digital(R, h).value;
    }
    const auto estimator =
        variant.make(scene.set, {method.evaluation.value_or(EstimatorOptions{}.evaluation), sweep.centre});
    Estimates estimates;
    record.seconds_init = timed(study.timing, [&] { estimator->init(h, R); });
    record.seconds_eval = timed(study.timing, [&] { estimates = estimator->eval(scene.surfels); });
    record.work = estimator->work();
    if (method.evaluation == sweep.evaluations.front())
      first_sums = estimator->raw();
    else if (method.evaluation && estimator->raw().columns != first_sums->columns)
      throw std::runtime_error(
          fmt::format("{} at h = {}: the sums of evaluation '{}' differ from those of '{}'", common.shape,
                      h.value, record.evaluation, to_string(sweep.evaluations.front())));
    for (const Compared& compared : compared_quantities(variant)) {
      const std::vector<double> errors = known_only(errors_of(compared, estimates, truth), truth);
      if (!errors.empty()) record.errors.emplace_back(compared.name, error_norms(errors));
    }
    records.push_back(std::move(record));
  }
  return records;
}

/// Fails before anything is computed or written where the largest job of a sweep would not fit.
void check_memory(const Sweep& sweep, const std::vector<AnyShape>& shapes) {
  const GridStep h{sweep.schedule.values().back()};
  const int threads = tbb::this_task_arena::max_concurrency();
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (const Method& method : sweep.methods())
      std::visit(
          [&]<int d>(const std::shared_ptr<const Shape<d>>& shape) {
            const DigitalLength radius =
                method.radius ? to_digital(method.radius->at(h), h) : DigitalLength{1};
            require_memory(predicted_memory<d>(shape->bounds(), h, radius, d == 3,
                                               method.evaluation.value_or(EstimatorOptions{}.evaluation), threads),
                           fmt::format("{} at h = {:.6g}", sweep.shapes[i].canonical(), h.value));
          },
          shapes[i]);
}

}  // namespace

std::vector<Record> run_study(const Study& study, const nlohmann::json& source, const RunOptions& options) {
  std::map<const Sweep*, std::vector<AnyShape>> shapes;
  for (const Sweep& sweep : study.sweeps) {
    for (const ShapeSpec& spec : sweep.shapes) shapes[&sweep].push_back(make_shape(spec));
    check_memory(sweep, shapes[&sweep]);
  }

  std::optional<Journal> journal;
  std::vector<Record> records;
  const std::vector<Job> jobs = jobs_of(study);
  std::size_t finished = 0;
  if (!options.journal.empty()) {
    if (!options.resume && std::filesystem::exists(options.journal))
      throw InputError(
          options.journal.string() +
          ": an unfinished run of a study; --resume goes on with it, removing the file starts anew");
    journal.emplace(options.journal, nlohmann::ordered_json{{"journal", 1},
                                                            {"study", source},
                                                            {"seed", study.seed},
                                                            {"version", build_info().version},
                                                            {"commit", build_info().commit}});
    for (const nlohmann::ordered_json& line : journal->records()) {
      const bool expected = finished < jobs.size() && line.size() == jobs[finished].sweep->methods().size();
      ++finished;
      if (!expected)
        throw InputError(
            fmt::format("{}: line {} is not of this study", options.journal.string(), finished + 1));
      for (const nlohmann::ordered_json& record : line) records.push_back(record_from(record));
    }
  }

  const auto run = [&](const Job& job, auto function) {
    return std::visit(function, shapes.at(job.sweep)[job.shape]);
  };
  const auto work = [&](const Job& job) {
    return run(job, [&]<int d>(const std::shared_ptr<const Shape<d>>& shape) {
      return work_of<d>(*job.sweep, *shape, {job.sweep->schedule.values()[job.level]});
    });
  };
  std::optional<Progress> progress;
  if (options.progress) {
    double total = 0;
    for (const Job& job : jobs) total += work(job);
    progress.emplace(total, options.progress);
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Job& job = jobs[i];
    const ShapeSpec& spec = job.sweep->shapes[job.shape];
    if (i >= finished) {
      const std::vector<Record> done = run(job, [&]<int d>(const std::shared_ptr<const Shape<d>>& shape) {
        try {
          return run_job<d>(study, job, *shape);
        } catch (const InputError& error) {
          // A journal without a finished job would only stand in the way of the corrected study.
          std::error_code ignored;
          if (journal && records.empty()) std::filesystem::remove(options.journal, ignored);
          throw InputError(fmt::format("{}: {}", spec.canonical(), error.what()));
        }
      });
      if (journal) {
        nlohmann::ordered_json lines = nlohmann::ordered_json::array();
        for (const Record& record : done) lines.push_back(to_json(record));
        journal->append(lines);
      }
      records.insert(records.end(), done.begin(), done.end());
    }
    if (progress)
      progress->advance(work(job),
                        fmt::format("{} h = {:.4g}", spec.name, job.sweep->schedule.values()[job.level]));
  }
  return records;
}

}  // namespace gridstep
