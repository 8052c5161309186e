#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "experiments/core/norms.hpp"
#include "experiments/core/output_file.hpp"
#include "experiments/core/text.hpp"
#include "experiments/memory.hpp"
#include "experiments/program/commands.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/base/contracts.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

namespace {

struct Options {
  std::string shape, estimator, evaluation = "masks", centre = "spels", csv;
  double h = 0, radius = 0, k = 0, alpha = 1.0 / 3.0, noise = 0;
  std::vector<double> shift;
  std::uint64_t seed = 1;
  int threads = 0;
  bool raw = false, has_radius = false;
};

double checked(const char* option, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw InputError(fmt::format("{} = {}: must be a positive finite number", option, value));
  return value;
}

/// The CSV that --help describes; an empty field where a surfel has no truth.
template <int d>
void write_csv(const std::string& path, const Scene<d>& scene, const Estimates& estimates,
               const Estimates* raw, const Truth& truth, const std::vector<std::string>& judged) {
  OutputFile file(path);
  const std::string axes = "xyz";
  std::string header;
  for (int k = 0; k < d; ++k) header += fmt::format("k{},", axes[k]);
  for (int k = 0; k < d; ++k) header += fmt::format("{},", axes[k]);
  for (const std::string& name : estimates.quantities) header += name + ",";
  if (raw)
    for (const std::string& name : raw->quantities) header += name + ",";
  for (const std::string& name : truth.quantities) header += "true_" + name + ",";
  for (std::size_t q = 0; q < judged.size(); ++q) header += q == 0 ? "error," : "error_" + judged[q] + ",";
  header.back() = '\n';
  file.write(header);

  std::vector<std::pair<const std::vector<double>*, const std::vector<double>*>> compared;  // estimate, truth
  for (const std::string& name : judged)
    for (std::size_t t = 0; t < truth.quantities.size(); ++t)
      if (truth.quantities[t] == name) compared.emplace_back(&estimates[name], &truth.columns[t]);
  fmt::memory_buffer line;
  for (std::size_t i = 0; i < scene.surfels.size(); ++i) {
    line.clear();
    const auto out = std::back_inserter(line);
    const Cell<d> cell = scene.surfels[i].cell();
    const RealPoint<d> position = centre(scene.surfels[i], scene.settings.h.value);
    for (int k = 0; k < d; ++k) fmt::format_to(out, "{},", cell.coordinates[k]);
    for (int k = 0; k < d; ++k) fmt::format_to(out, "{},", position[k]);
    for (const auto& column : estimates.columns) fmt::format_to(out, "{},", column[i]);
    if (raw)
      for (const auto& column : raw->columns) fmt::format_to(out, "{},", column[i]);
    for (const auto& column : truth.columns)
      truth.known[i] ? fmt::format_to(out, "{},", column[i]) : fmt::format_to(out, ",");
    for (const auto& [estimate, exact] : compared)
      truth.known[i] ? fmt::format_to(out, "{},", (*estimate)[i] - (*exact)[i]) : fmt::format_to(out, ",");
    line.data()[line.size() - 1] = '\n';
    file.write({line.data(), line.size()});
  }
  file.commit();
}

template <int d>
void run(const Options& options, const Shape<d>& shape) {
  const GridStep h{checked("--h", options.h)};
  if (!(options.alpha >= 0 && options.alpha < 1))
    throw InputError(fmt::format("--alpha = {}: must be in [0, 1)", options.alpha));
  const EuclideanLength R{options.has_radius
                              ? checked("--radius", options.radius)
                              : RadiusRule{checked("--k", options.k), options.alpha}.at(h).value};
  SceneSettings<d> settings;
  settings.h = h;
  if (!options.shift.empty()) {
    if (options.shift.size() != d)
      throw InputError(fmt::format("--shift has {} numbers, the shape is {}D", options.shift.size(), d));
    for (int k = 0; k < d; ++k) {
      settings.placement.shift[k] = options.shift[std::size_t(k)];
      if (!std::isfinite(settings.placement.shift[k]))
        throw InputError(fmt::format("--shift = {}: must be finite", settings.placement.shift[k]));
    }
  }
  if (!(options.noise >= 0 && options.noise < 1))
    throw InputError(fmt::format("--noise = {}: must be in [0, 1)", options.noise));
  settings.noise = options.noise;
  settings.noise_seed = options.seed;

  const auto& variant = find_estimator(options.estimator).variant<d>();
  const EstimatorOptions how{parse_evaluation(options.evaluation), parse_kernel_centre(options.centre)};
  const DigitalLength radius = to_digital(R, h);
  if (!(radius.value >= 1))
    throw InputError(fmt::format("R/h = {:.6g} (R = {:.6g}, h = {:.6g}): must be at least 1", radius.value,
                                 R.value, h.value));
  require_memory(predicted_memory<d>(shape.bounds(), h, radius, d == 3 && variant.quantities.size() > 1,
                                     how.evaluation, tbb::this_task_arena::max_concurrency()),
                 fmt::format("{} at h = {}", options.shape, h.value));

  const Scene<d> scene = [&] {
    try {
      return make_scene<d>(shape, settings);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", options.shape, error.what()));
    }
  }();
  const auto estimator = variant.make(scene.set, how);
  auto start = std::chrono::steady_clock::now();
  const auto lap = [&start] {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start).count();
    start = now;
    return seconds;
  };
  estimator->init(h, R);
  const double seconds_init = lap();
  const Estimates estimates = estimator->eval(scene.surfels);
  const double seconds_eval = lap();

  std::vector<std::string> judged;
  for (const Quantity& quantity : variant.quantities)
    if (quantity.proven_rate) judged.push_back(quantity.name);
  const Truth truth = truth_at_surfels<d>(shape, settings, scene.surfels, estimates.quantities);

  // With the CSV on standard output, the summary goes to standard error.
  std::FILE* out = options.csv == "-" || options.csv == "/dev/stdout" ? stderr : stdout;
  if (!options.csv.empty()) {
    const Estimates raw = options.raw ? estimator->raw() : Estimates{};
    write_csv<d>(options.csv == "-" ? "/dev/stdout" : options.csv, scene, estimates,
                 options.raw ? &raw : nullptr, truth, judged);
  }
  const EstimatorWork work = estimator->work();
  fmt::print(out, "{} at h = {}, R = {:.6g} (R/h = {:.6g}), {}\n", options.shape, h.value, R.value,
             radius.value, options.estimator);
  fmt::print(out, "surfels {}", scene.surfels.size());
  if (scene.components > 0) fmt::print(out, ", components {}", scene.components);
  if (truth.singular > 0) fmt::print(out, ", {} at singular points (left out)", truth.singular);
  if (truth.far > 0) fmt::print(out, ", {} far from the boundary (left out)", truth.far);
  fmt::print(out, "; truth residual <= {:.2g} of the size\n", truth.worst_residual);
  for (const std::string& name : judged) {
    std::vector<double> errors;
    for (std::size_t q = 0; q < truth.quantities.size(); ++q)
      if (truth.quantities[q] == name)
        for (std::size_t i = 0; i < scene.surfels.size(); ++i)
          if (truth.known[i]) errors.push_back(estimates[name][i] - truth.columns[q][i]);
    if (errors.empty()) continue;
    const ErrorNorms norms = error_norms(errors);
    fmt::print(out, "error of {:<9} sup {}  rms {}  mean {}\n", name, format_error(norms.sup),
               format_error(norms.rms), format_error(norms.mean));
  }
  fmt::print(out, "{}: {} kernel evaluations, {} cells visited, {} restarts; kernel of {} cells",
             options.evaluation, work.evaluations, work.cells_visited, work.restarts, work.kernel_size);
  if (!work.mask_sizes.empty()) {
    const auto [least, most] = std::minmax_element(work.mask_sizes.begin(), work.mask_sizes.end());
    fmt::print(out, ", {} masks that gain (and lose) {} to {}", work.mask_sizes.size(), *least, *most);
  }
  fmt::print(out, "\n");
  fmt::print(out, "init {}, evaluation {} ({:.0f} ns a surfel)\n", format_seconds(seconds_init),
             format_seconds(seconds_eval), 1e9 * seconds_eval / double(scene.surfels.size()));
}

}  // namespace

void add_estimate_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("estimate", "One estimator on one digitized shape");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("--shape", options->shape, "Such as ellipse:a=20,b=7,angle=0.3; see gridstep list shapes")
      ->required();
  command->add_option("--h", options->h, "Grid step")->required();
  command->add_option("--estimator", options->estimator, "See gridstep list estimators")->required();
  auto* radius =
      command->add_option("--radius", options->radius, "Kernel radius R, in the unit of the shape");
  auto* k = command->add_option("--k", options->k, "R = K h^ALPHA")->excludes(radius);
  command->add_option("--alpha", options->alpha, "Exponent of h in R (default: 1/3)")->needs(k);
  command->add_option("--evaluation", options->evaluation, "masks (default) or full; the sums are the same");
  command->add_option("--centre", options->centre,
                      "Kernel centres: spels (default; mean of inner and outer) or surfel");
  command->add_option("--shift", options->shift, "Sub-grid shift of the shape, in cells: X,Y[,Z]")
      ->delimiter(',');
  command->add_option("--noise", options->noise, "Kanungo noise: beta in [0, 1)");
  command->add_option("--seed", options->seed, "Seed of the noise")->check(not_negative);
  command->add_option("--csv", options->csv, "File for one row a surfel; - is standard output");
  command->add_flag("--raw", options->raw, "In the CSV, also the sums that the estimates come from");
  command->add_option("--threads", options->threads, "Number of threads (default: all)")
      ->check(CLI::Range(1, 4096));
  command->footer(
      "The CSV has a header and one row a surfel (2D: along the contours, shape on the left):\n"
      "  kx,ky[,kz]    Khalimsky coordinates; the spel z has 2z+1, a surfel one even coordinate\n"
      "  x,y[,z]       centre of the surfel, in the unit of the shape\n"
      "  the estimator's quantities: kappa; mean, gaussian, k1, k2, normal_x, dir1_x, dir2_x, ...\n"
      "  with --raw: sum (mean of inner and outer sum), in 3D cov_xx, cov_xy, cov_xz, cov_yy, cov_yz, "
      "cov_zz\n"
      "  true_kappa, ...: exact values at the closest boundary point; empty at singular points\n"
      "  error (of the first quantity), error_gaussian, ...: estimate minus truth\n"
      "Examples:\n"
      "  gridstep estimate --shape flower:radius=20,amplitude=7,petals=6 --h 0.1 --estimator ii --k 5 --csv "
      "flower.csv\n"
      "  gridstep estimate --shape goursat --h 0.25 --shift 0.1,0.2,0.3 --estimator ii-covariance --radius 2 "
      "--csv - --raw");
  command->callback([options, command] {
    options->has_radius = command->count("--radius") > 0;
    if (!options->has_radius && command->count("--k") == 0)
      throw InputError("one of --radius and --k is needed");
    std::optional<tbb::global_control> limit;
    if (options->threads > 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options->threads));
    std::visit([&]<int d>(const std::shared_ptr<const Shape<d>>& shape) { run<d>(*options, *shape); },
               make_shape(ShapeSpec::parse(options->shape)));
  });
}

}  // namespace gridstep
