#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "experiments/compared.hpp"
#include "experiments/core/norms.hpp"
#include "experiments/core/output_file.hpp"
#include "experiments/core/text.hpp"
#include "experiments/memory.hpp"
#include "experiments/program/commands.hpp"
#include "experiments/program/surfel_csv.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/base/contracts.hpp"
#include "shapes/digital/image_file.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

namespace {

struct Options {
  std::string shape, image, evaluation = "masks", centre = "spels", csv;
  std::vector<std::string> estimators;
  double h = 0, radius = 0, k = 0, alpha = 1.0 / 3.0, noise = 0;
  std::vector<double> shift;
  std::vector<int> threshold;
  std::uint64_t seed = 1;
  int threads = 0;
  bool raw = false, has_radius = false, has_k = false;
};

double checked(const char* option, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw InputError(fmt::format("{} = {}: must be a positive finite number", option, value));
  return value;
}

/// What an estimator gave on a boundary.
template <int d>
struct Estimation {
  std::string name;
  const EstimatorEntry::Variant<d>* variant;
  Estimates estimates, raw;
  EstimatorWork work;
  double seconds_init, seconds_eval;
};

/// The radius that the options ask for, in one of two ways, if they do.
std::optional<EuclideanLength> radius_of(const Options& options, GridStep h) {
  if (!(options.alpha >= 0 && options.alpha < 1))
    throw InputError(fmt::format("--alpha = {}: must be in [0, 1)", options.alpha));
  std::optional<EuclideanLength> R;
  if (options.has_radius) R = EuclideanLength{checked("--radius", options.radius)};
  if (options.has_k) R = RadiusRule{checked("--k", options.k), options.alpha}.at(h);
  if (R && !(to_digital(*R, h).value >= 1))
    throw InputError(fmt::format("R/h = {:.6g} (R = {:.6g}, h = {:.6g}): must be at least 1",
                                 to_digital(*R, h).value, R->value, h.value));
  return R;
}

/// The estimators by name, with the way of evaluation checked. All must exist in dimension d, and those that
/// need a radius must have one.
template <int d>
std::vector<Estimation<d>> chosen(const Options& options, const std::optional<EuclideanLength>& R) {
  std::vector<Estimation<d>> result;
  bool radius_used = false;
  for (const std::string& name : options.estimators) {
    const auto& variant = find_estimator(name).variant<d>();
    if (variant.takes_radius && !R)
      throw InputError(fmt::format("estimator '{}' needs one of --radius and --k", name));
    radius_used |= variant.takes_radius;
    result.push_back({name, &variant, {}, {}, {}, 0, 0});
  }
  if ((options.has_radius || options.has_k) && !radius_used)
    throw InputError(fmt::format("--{}: estimator '{}' takes no radius", options.has_radius ? "radius" : "k",
                                 options.estimators.front()));
  return result;
}

template <int d>
void evaluate(std::vector<Estimation<d>>& estimations, const DigitalSet<d>& set,
              std::span<const Surfel<d>> surfels, GridStep h, EuclideanLength R, const Options& options) {
  const EstimatorOptions how{parse_evaluation(options.evaluation), parse_kernel_centre(options.centre)};
  for (Estimation<d>& e : estimations) {
    const auto estimator = e.variant->make(set, how);
    auto start = std::chrono::steady_clock::now();
    const auto lap = [&start] {
      const auto now = std::chrono::steady_clock::now();
      const double seconds = std::chrono::duration<double>(now - start).count();
      start = now;
      return seconds;
    };
    estimator->init(h, R);
    e.seconds_init = lap();
    e.estimates = estimator->eval(surfels);
    e.seconds_eval = lap();
    if (options.raw) e.raw = estimator->raw();
    e.work = estimator->work();
  }
}

/// The columns of one estimator, as --help describes them; `truth` where it is known. With several
/// estimators, their titles start with its name. `errors` holds what the last columns point to.
template <int d>
void add_columns(std::vector<SurfelColumn>& columns, const Estimation<d>& e, const std::string& prefix,
                 const Truth* truth, std::vector<std::vector<double>>& errors) {
  for (const Estimates* values : {&e.estimates, &e.raw})
    for (std::size_t q = 0; q < values->quantities.size(); ++q)
      columns.push_back({prefix + values->quantities[q], &values->columns[q]});
  if (!truth) return;
  for (const std::string& quantity : e.estimates.quantities)
    for (std::size_t q = 0; q < truth->quantities.size(); ++q)
      if (truth->quantities[q] == quantity)
        columns.push_back({prefix + "true_" + quantity, &truth->columns[q], &truth->known});
  bool first = true;
  for (const Compared& compared : compared_quantities(*e.variant)) {
    errors.push_back(errors_of(compared, e.estimates, *truth));
    columns.push_back({prefix + (first ? "error" : "error_" + compared.name), &errors.back(), &truth->known});
    first = false;
  }
}

/// `truths` is empty where there is no shape to compare with.
template <int d>
void write_csv(OutputFile& file, const std::vector<Estimation<d>>& estimations,
               std::span<const Surfel<d>> surfels, GridStep h, std::span<const std::size_t> component_begin,
               const std::map<ValuePosition, Truth>& truths) {
  std::vector<SurfelColumn> columns;
  std::vector<std::vector<double>> errors;
  errors.reserve(16 * estimations.size());  // columns point into it
  bool pointels = false;
  for (const Estimation<d>& e : estimations) {
    pointels |= e.variant->position == ValuePosition::start_pointel;
    add_columns(columns, e, estimations.size() > 1 ? e.name + "." : "",
                truths.empty() ? nullptr : &truths.at(e.variant->position), errors);
  }
  write_surfel_csv<d>(file, surfels, h, pointels, component_begin, columns);
  file.commit();
}

template <int d>
void print_work(std::FILE* out, const Estimation<d>& e, const Options& options, std::size_t surfels) {
  const EstimatorWork& work = e.work;
  if (e.variant->takes_radius) {
    fmt::print(out, "{}: {} kernel evaluations, {} cells visited, {} restarts; kernel of {} cells",
               options.evaluation, work.evaluations, work.cells_visited, work.restarts, work.kernel_size);
    if (!work.mask_sizes.empty()) {
      const auto [least, most] = std::minmax_element(work.mask_sizes.begin(), work.mask_sizes.end());
      fmt::print(out, ", {} masks that gain (and lose) {} to {}", work.mask_sizes.size(), *least, *most);
    }
    fmt::print(out, "\n");
  }
  fmt::print(out, "init {}, evaluation {} ({:.0f} ns a surfel)\n", format_seconds(e.seconds_init),
             format_seconds(e.seconds_eval), 1e9 * e.seconds_eval / double(surfels));
}

std::string radius_text(const std::optional<EuclideanLength>& R, GridStep h) {
  return R ? fmt::format(", R = {:.6g} (R/h = {:.6g})", R->value, to_digital(*R, h).value) : "";
}

/// The file that --csv names, opened before anything is computed: what cannot be written is known at once.
std::unique_ptr<OutputFile> open_csv(const Options& options) {
  if (options.csv.empty()) return nullptr;
  return std::make_unique<OutputFile>(options.csv == "-" ? "/dev/stdout" : options.csv);
}

/// With the CSV on standard output, the summary goes to standard error.
std::FILE* summary_stream(const Options& options) {
  return options.csv == "-" || options.csv == "/dev/stdout" ? stderr : stdout;
}

template <int d>
SceneSettings<d> scene_settings(const Options& options, GridStep h) {
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
  return settings;
}

template <int d>
void run_shape(const Options& options, const Shape<d>& shape) {
  const GridStep h{checked("--h", options.h)};
  const std::optional<EuclideanLength> R = radius_of(options, h);
  const SceneSettings<d> settings = scene_settings<d>(options, h);
  std::vector<Estimation<d>> estimations = chosen<d>(options, R);
  const Evaluation evaluation = parse_evaluation(options.evaluation);
  parse_kernel_centre(options.centre);
  const double surfels = predicted_surfels<d>(shape.bounds(), h);
  double bytes = predicted_set_memory<d>(shape.bounds(), h), tables = 0;
  for (const Estimation<d>& e : estimations) {
    bytes += surfels * predicted_surfel_memory(d == 3 && e.variant->quantities.size() > 1);
    if (R && e.variant->takes_radius)
      tables = std::max(tables, predicted_table_memory<d>(to_digital(*R, h), evaluation,
                                                          tbb::this_task_arena::max_concurrency()));
  }
  const double predicted = bytes + tables;
  require_memory(predicted, fmt::format("{} at h = {}", options.shape, h.value));
  const std::unique_ptr<OutputFile> csv = open_csv(options);

  const Scene<d> scene = [&] {
    try {
      return make_scene<d>(shape, settings);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", options.shape, error.what()));
    }
  }();
  evaluate<d>(estimations, scene.set, scene.surfels, h, R.value_or(EuclideanLength{0}), options);

  std::map<ValuePosition, std::vector<std::string>> quantities;
  for (const Estimation<d>& e : estimations)
    for (const std::string& name : e.estimates.quantities) {
      auto& names = quantities[e.variant->position];
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  std::map<ValuePosition, Truth> truths;
  for (const auto& [position, names] : quantities)
    truths[position] = truth_at<d>(shape, settings, value_points<d>(position, scene.surfels, h),
                                   farthest_from_boundary(position, h), names);
  if (csv) write_csv<d>(*csv, estimations, scene.surfels, h, {}, truths);

  std::FILE* out = summary_stream(options);
  fmt::print(out, "{} at h = {}{}, {}\n", options.shape, h.value, radius_text(R, h),
             fmt::join(options.estimators, ", "));
  fmt::print(out, "surfels {}", scene.surfels.size());
  if (scene.components > 0) fmt::print(out, ", components {}", scene.components);
  const Truth& truth = truths.begin()->second;
  if (truth.singular > 0) fmt::print(out, ", {} at singular points (left out)", truth.singular);
  if (truth.far > 0) fmt::print(out, ", {} far from the boundary (left out)", truth.far);
  fmt::print(out, "; truth residual <= {:.2g} of the size\n", truth.worst_residual);
  for (const Estimation<d>& e : estimations) {
    if (estimations.size() > 1) fmt::print(out, "{}\n", e.name);
    const Truth& exact = truths.at(e.variant->position);
    for (const Compared& compared : compared_quantities(*e.variant)) {
      const std::vector<double> errors = known_only(errors_of(compared, e.estimates, exact), exact);
      if (errors.empty()) continue;
      const ErrorNorms norms = error_norms(errors);
      fmt::print(out, "error of {:<9} sup {}  rms {}  mean {}\n", compared.name, format_error(norms.sup),
                 format_error(norms.rms), format_error(norms.mean));
    }
    print_work(out, e, options, scene.surfels.size());
  }
  fmt::print(out, "{}\n", memory_report(predicted, std::int64_t(scene.surfels.size())));
}

/// For images, in pixels.
constexpr double kDefaultRadius = 5;

std::vector<std::string> all_2d_estimators() {
  std::vector<std::string> names;
  for (const EstimatorEntry& entry : estimator_catalogue())
    if (entry.in_2d) names.push_back(entry.name);
  return names;
}

void run_image(Options options) {
  const GridStep h{options.h == 0 ? 1.0 : checked("--h", options.h)};
  const EuclideanLength R = radius_of(options, h).value_or(EuclideanLength{kDefaultRadius * h.value});
  if (options.estimators.empty()) options.estimators = all_2d_estimators();
  std::vector<Estimation<2>> estimations = chosen<2>(options, R);
  const GreyImage image = read_image(options.image);
  if (options.threshold.empty()) {
    const auto [least, most] = std::minmax_element(image.values.begin(), image.values.end());
    if (*most > 1)
      throw InputError(fmt::format(
          "{}: a grey image, with values from {} to {}; --threshold LOW,HIGH says which are the foreground",
          options.image, *least, *most));
    options.threshold = {1, 1};
  }
  if (options.threshold.size() != 2 || options.threshold[0] > options.threshold[1])
    throw InputError(fmt::format("--threshold = {}: must be LOW,HIGH with LOW <= HIGH",
                                 fmt::join(options.threshold, ",")));
  const std::unique_ptr<OutputFile> csv = open_csv(options);
  const DigitalSet<2> set = threshold(image, options.threshold[0], options.threshold[1]);
  const DigitalSurface<2> contours = connected_boundary(set);
  evaluate<2>(estimations, set, contours.surfels, h, R, options);
  if (csv) write_csv<2>(*csv, estimations, contours.surfels, h, contours.component_begin, {});

  std::FILE* out = summary_stream(options);
  fmt::print(out, "{}: {} x {} pixels, {} in [{}, {}], h = {}{}\n", options.image, image.width, image.height,
             set.size(), options.threshold[0], options.threshold[1], h.value, radius_text(R, h));
  const auto& begin = contours.component_begin;
  for (std::size_t c = 0; c < contours.components(); ++c) {
    fmt::print(out, "contour {}: {} linels\n", c, begin[c + 1] - begin[c]);
    for (const Estimation<2>& e : estimations)
      for (std::size_t q = 0; q < e.estimates.quantities.size(); ++q) {
        const auto first = e.estimates.columns[q].begin();
        const auto [least, most] =
            std::minmax_element(first + std::ptrdiff_t(begin[c]), first + std::ptrdiff_t(begin[c + 1]));
        fmt::print(out, "  {:<18} {:<10} from {:.4g} to {:.4g}\n", e.name, e.estimates.quantities[q], *least,
                   *most);
      }
  }
  for (const Estimation<2>& e : estimations) {
    fmt::print(out, "{}: ", e.name);
    print_work(out, e, options, contours.surfels.size());
  }
}

}  // namespace

void add_estimate_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("estimate", "Estimators on one digitized shape, or on the contours of an image");
  const auto options = std::make_shared<Options>();
  auto* shape =
      command->add_option("--shape", options->shape, "Such as ellipse:a=20,b=7; see gridstep list shapes");
  auto* image = command->add_option("--image", options->image, "PGM or PBM file, instead of a shape");
  image->excludes(shape);
  auto* threshold = command->add_option("--threshold", options->threshold,
                                        "Of the image: LOW,HIGH, the grey values of the foreground, both "
                                        "included (default for PBM: black)");
  threshold->delimiter(',')->needs(image);
  command->add_option("--h", options->h, "Grid step (default for images: 1, the pixel)");
  command
      ->add_option("--estimator", options->estimators,
                   "One or several: NAME,NAME; see gridstep list estimators (default for images: all)")
      ->delimiter(',');
  auto* radius =
      command->add_option("--radius", options->radius,
                          "Kernel radius R, in the unit of the shape (default for images: 5 pixels)");
  auto* k = command->add_option("--k", options->k, "R = K h^ALPHA")->excludes(radius);
  command->add_option("--alpha", options->alpha, "Exponent of h in R (default: 1/3)")->needs(k);
  command->add_option("--evaluation", options->evaluation,
                      "masks (default), full or bricks; the sums are the same");
  command->add_option("--centre", options->centre,
                      "Kernel centres: spels (default; mean of inner and outer) or surfel");
  command->add_option("--shift", options->shift, "Sub-grid shift of the shape, in cells: X,Y[,Z]")
      ->delimiter(',')
      ->needs(shape);
  command->add_option("--noise", options->noise, "Kanungo noise: beta in [0, 1)")->needs(shape);
  command->add_option("--seed", options->seed, "Seed of the noise")->check(not_negative);
  command->add_option("--csv", options->csv, "File for one row a surfel; - is standard output");
  command->add_flag("--raw", options->raw, "In the CSV, also the sums that the estimates come from");
  command->add_option("--threads", options->threads, "Number of threads (default: all)")
      ->check(CLI::Range(1, 4096));
  command->footer(
      "The CSV has a header and one row a surfel (2D: along the contours, shape on the left):\n"
      "  kx,ky[,kz]    Khalimsky coordinates; the spel z has 2z+1, a surfel one even coordinate\n"
      "  px,py         the pointel at which the linel starts, where an estimator's values belong to it\n"
      "  x,y[,z]       centre of the surfel, in the unit of the shape\n"
      "  component     number of the contour (images)\n"
      "  the estimator's quantities: kappa; tangent_x, tangent_y; mean, gaussian, k1, k2, normal_x, ...\n"
      "  with --raw: sum (mean of inner and outer sum), in 3D cov_xx, cov_xy, cov_xz, cov_yy, cov_yz, "
      "cov_zz\n"
      "  true_kappa, ...: exact values at the closest boundary point; empty at singular points\n"
      "  error (of the first quantity), error_gaussian, ...: estimate minus truth; of vectors, the angle\n"
      "With several estimators, each has its columns: mdca.kappa, mdca.true_kappa, mdca.error, ...\n"
      "Examples:\n"
      "  gridstep estimate --shape flower:radius=20,amplitude=7,petals=6 --h 0.1 --estimator ii --k 5 --csv "
      "flower.csv\n"
      "  gridstep estimate --shape goursat --h 0.25 --shift 0.1,0.2,0.3 --estimator ii-covariance --radius 2 "
      "--csv - --raw\n"
      "  gridstep estimate --shape ellipse:a=20,b=7 --h 0.1 --estimator mdca,bc,lambda-mst\n"
      "  gridstep estimate --image contour.pgm --threshold 0,127 --radius 5 --csv contours.csv");
  command->callback([options, command] {
    options->has_radius = command->count("--radius") > 0;
    options->has_k = command->count("--k") > 0;
    std::optional<tbb::global_control> limit;
    if (options->threads > 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options->threads));
    if (command->count("--image") > 0) return run_image(*options);
    if (command->count("--shape") == 0) throw InputError("one of --shape and --image is needed");
    for (const char* needed : {"--h", "--estimator"})
      if (command->count(needed) == 0) throw InputError(fmt::format("{} is needed with --shape", needed));
    std::visit([&]<int d>(const std::shared_ptr<const Shape<d>>& made) { run_shape<d>(*options, *made); },
               make_shape(ShapeSpec::parse(options->shape)));
  });
}

}  // namespace gridstep
