#include "experiments/runner.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/compared.hpp"
#include "experiments/core/build_info.hpp"
#include "experiments/core/journal.hpp"
#include "experiments/core/progress.hpp"
#include "experiments/job.hpp"
#include "experiments/memory.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

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

/// By how many powers of R/h an evaluation reads less than the whole kernel; an estimator without one looks at the
/// surface in a ball.
int steps_saved(const std::optional<Evaluation>& evaluation) {
  if (!evaluation) return 1;
  return evaluation == Evaluation::full ? 0 : evaluation == Evaluation::masks ? 1 : 2;
}

/// Proportional to the expected time: cells read at every surfel of the bounding box.
template <int d>
double work_of(const Sweep& sweep, const Shape<d>& shape, GridStep h) {
  const double surfels = std::pow(shape.size() / h.value, d - 1);
  double reads = 300;  // digitization and truth
  for (const Method& method : sweep.methods())
    reads += method.radius
                 ? std::pow(to_digital(method.radius->at(h), h).value, d - steps_saved(method.evaluation))
                 : 300;
  return surfels * reads;
}

template <int d>
double predicted_job_memory(const Sweep& sweep, const std::string& name, const Shape<d>& shape, GridStep h) {
  const int threads = tbb::this_task_arena::max_concurrency();
  SceneSettings<d> settings;
  settings.h = h;
  settings.noise = *std::max_element(sweep.noise.begin(), sweep.noise.end());
  auto [surfels, bytes] = predicted_size(name, shape, settings);
  bytes += predicted_surfel_memory(d == 3) *
           (comes_in_parts(settings) ? std::min(surfels, double(kSurfelsInPart)) : surfels);
  for (const Method& method : sweep.methods()) {
    bytes += double(sizeof(double)) * surfels * double(compared_quantities(method.estimator, d).size());
    if (method.evaluation)
      bytes += predicted_table_memory<d>(find_estimator(method.estimator).variant<d>(),
                                         to_digital(method.radius->at(h), h), *method.evaluation, threads);
  }
  return bytes;
}

}  // namespace

double predicted_memory(const Study& study) {
  double most = 0;
  for (const Sweep& sweep : study.sweeps) {
    const GridStep h{sweep.schedule.values().back()};
    for (const ShapeSpec& spec : sweep.shapes) {
      const double bytes = std::visit(
          [&]<int d>(const std::shared_ptr<const Shape<d>>& shape) {
            return predicted_job_memory<d>(sweep, spec.canonical(), *shape, h);
          },
          make_shape(spec));
      require_memory(bytes, fmt::format("{} at h = {:.6g}", spec.canonical(), h.value));
      most = std::max(most, bytes);
    }
  }
  return most;
}

std::vector<Record> run_study(const Study& study, const nlohmann::json& source, const RunOptions& options) {
  predicted_memory(study);
  std::map<const Sweep*, std::vector<AnyShape>> shapes;
  for (const Sweep& sweep : study.sweeps)
    for (const ShapeSpec& spec : sweep.shapes) shapes[&sweep].push_back(make_shape(spec));

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
      return work_of<d>(*job.sweep, *shape, job.h());
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
    if (progress) progress->advance(work(job), fmt::format("{} h = {:.4g}", spec.name, job.h().value));
  }
  return records;
}

}  // namespace gridstep
