#include "experiments/job.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "experiments/compared.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Evaluates on one thread, several times where that is quick, and returns the shortest time.
template <class Function>
double timed(bool alone, Function evaluate) {
  const auto once = [&] {
    const Stopwatch watch;
    evaluate();
    return watch.seconds();
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

template <int d>
SceneSettings<d> settings_of(const Study& study, const Job& job) {
  RandomStream random{study.seed, job.level, std::uint64_t(job.shift)};
  SceneSettings<d> settings;
  settings.h = job.h();
  settings.placement.shift = random_shift<d>(random);
  if (job.sweep->rotate) settings.placement.rotation = random_rotation<d>(random);
  settings.noise = job.sweep->noise[job.noise];
  settings.noise_seed = random.bits();
  return settings;
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
    const Stopwatch watch;
    const GridStep h = scene.settings.h;
    Truth truth = truth_at<d>(shape, scene.settings, value_points<d>(position, scene.surfels, h),
                              farthest_from_boundary(position, h), names);
    truths[position] = {std::move(truth), watch.seconds()};
  }
  return truths;
}

/// One method of a job, over all parts of the boundary.
template <int d>
class MethodRun {
 public:
  MethodRun(const Sweep& sweep, const Method& method, const Record& common, bool timing)
      : method_(method),
        variant_(find_estimator(method.estimator).variant<d>()),
        centre_(variant_.centre(sweep.centre)),
        compared_(compared_quantities(variant_)),
        errors_(compared_.size()),
        record_(common),
        timing_(timing) {
    record_.estimator = method.estimator;
    if (!method.radius) return;
    const GridStep h{common.h};
    R_ = method.radius->at(h);
    if (method.evaluation) record_.evaluation = to_string(*method.evaluation);
    record_.centre = centre_ == KernelCentre::spels ? "spels" : "surfel";
    record_.k = method.radius->k;
    record_.alpha = method.radius->alpha;
    record_.digital_radius = to_digital(R_, h).value;
  }

  void add_part(const Scene<d>& scene, const std::map<ValuePosition, TruthAt>& truths) {
    if (!estimator_) {
      estimator_ =
          variant_.make(scene.set, {method_.evaluation.value_or(EstimatorOptions{}.evaluation), centre_});
      record_.seconds_init = timed(timing_, [&] { estimator_->init(scene.settings.h, R_); });
    }
    const auto& [truth, seconds_truth] = truths.at(variant_.position);
    Estimates estimates;
    record_.seconds_eval += timed(timing_, [&] { estimates = estimator_->eval(scene.surfels); });
    record_.work += estimator_->work();
    record_.surfels += std::int64_t(scene.surfels.size());
    record_.singular += truth.singular;
    record_.far += truth.far;
    record_.worst_residual = std::max(record_.worst_residual, truth.worst_residual);
    record_.seconds_truth += seconds_truth;
    parallel_chunks(compared_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c != end; ++c) {
        std::vector<double> known = known_only(errors_of(compared_[c], estimates, truth), truth);
        if (errors_[c].empty())
          errors_[c] = std::move(known);
        else
          errors_[c].insert(errors_[c].end(), known.begin(), known.end());
      }
    });
  }

  /// Of the last part.
  Estimates sums() const { return estimator_->raw(); }

  Record finish(double seconds_digitize) && {
    record_.seconds_digitize = seconds_digitize;
    std::vector<ErrorNorms> norms(compared_.size());
    parallel_chunks(compared_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c != end; ++c)
        if (!errors_[c].empty()) norms[c] = error_norms(errors_[c]);
    });
    for (std::size_t c = 0; c < compared_.size(); ++c)
      if (norms[c].count > 0) record_.errors.emplace_back(compared_[c].name, norms[c]);
    return std::move(record_);
  }

 private:
  const Method& method_;
  const typename EstimatorEntry::Variant<d>& variant_;
  KernelCentre centre_;
  std::vector<Compared> compared_;
  std::vector<std::vector<double>> errors_;
  Record record_;
  bool timing_;
  EuclideanLength R_{0};
  std::unique_ptr<Estimator<d>> estimator_;
};

}  // namespace

template <int d>
std::vector<Record> run_job(const Study& study, const Job& job, const Shape<d>& shape,
                            std::size_t surfels_in_part) {
  const Sweep& sweep = *job.sweep;
  const SceneSettings<d> settings = settings_of<d>(study, job);
  Record common;
  common.shape = sweep.shapes[job.shape].canonical();
  common.dimension = d;
  common.h = settings.h.value;
  common.noise = settings.noise;
  common.rotated = sweep.rotate;
  common.shift = job.shift;
  common.offset.assign(settings.placement.shift.begin(), settings.placement.shift.end());

  const std::vector<Method> methods = sweep.methods();
  std::vector<MethodRun<d>> runs;
  const Stopwatch whole;
  double seconds_in_parts = 0;
  for_each_part<d>(shape, settings, surfels_in_part, [&](const Scene<d>& scene) {
    const Stopwatch watch;
    common.components = std::int64_t(scene.components);
    if (runs.empty())
      for (const Method& method : methods) runs.emplace_back(sweep, method, common, study.timing);
    const std::map<ValuePosition, TruthAt> truths = truths_of(sweep, shape, scene);
    std::optional<Estimates> sums;  // of the method before, if this one is to have the same
    for (std::size_t m = 0; m < methods.size(); ++m) {
      runs[m].add_part(scene, truths);
      if (sums && runs[m].sums().columns != sums->columns)
        throw std::runtime_error(
            fmt::format("{} at h = {}: the sums of evaluation '{}' differ from those of '{}'", common.shape,
                        common.h, to_string(*methods[m].evaluation), to_string(*methods[m - 1].evaluation)));
      const bool once_more =
          m + 1 < methods.size() && methods[m].evaluation && methods[m + 1].agrees_with(methods[m]);
      sums = once_more ? std::optional(runs[m].sums()) : std::nullopt;
    }
    seconds_in_parts += watch.seconds();
  });

  const double seconds_digitize = whole.seconds() - seconds_in_parts;
  std::vector<Record> records;
  for (MethodRun<d>& run : runs) records.push_back(std::move(run).finish(seconds_digitize));
  return records;
}

template std::vector<Record> run_job(const Study&, const Job&, const Shape<2>&, std::size_t);
template std::vector<Record> run_job(const Study&, const Job&, const Shape<3>&, std::size_t);

}  // namespace gridstep
