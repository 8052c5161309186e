#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "experiments/compared.hpp"
#include "experiments/core/norms.hpp"
#include "experiments/core/text.hpp"
#include "experiments/memory.hpp"
#include "experiments/program/estimation.hpp"
#include "experiments/program/say.hpp"
#include "experiments/program/surfel_output.hpp"
#include "experiments/record.hpp"
#include "shapes/analytic/catalogue.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

namespace {

template <int d>
SceneSettings<d> scene_settings(const EstimateOptions& options, GridStep h) {
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

/// A column with values only where the truth is known. Both arguments have to outlive it.
SurfelColumn known_column(std::string title, const std::vector<double>& values, const Truth& truth) {
  return {std::move(title), SurfelColumn::Type::real, [&values, &truth](std::size_t i) {
            return truth.known[i] ? values[i] : std::numeric_limits<double>::quiet_NaN();
          }};
}

/// What is compared with the truth, among what --quantity wants.
template <int d>
std::vector<Compared> compared_and_wanted(const Estimation<d>& e, const EstimateOptions& options) {
  std::vector<Compared> result = compared_quantities(*e.variant);
  std::erase_if(result, [&](const Compared& c) { return !wanted(options, c.columns.front()); });
  return result;
}

/// The truth beside the estimates, and the errors, which `errors` holds. All arguments have to outlive the table.
template <int d>
void add_truth(SurfelTable& table, const Estimation<d>& e, const std::string& prefix, const Truth& truth,
               std::vector<std::vector<double>>& errors, const EstimateOptions& options) {
  for (const std::string& quantity : e.estimates.quantities)
    for (std::size_t q = 0; q < truth.quantities.size(); ++q)
      if (truth.quantities[q] == quantity && wanted(options, quantity))
        table.values.push_back(known_column(prefix + "true_" + quantity, truth.columns[q], truth));
  bool first = true;
  for (const Compared& compared : compared_and_wanted(e, options)) {
    errors.push_back(errors_of(compared, e.estimates, truth));
    table.values.push_back(
        known_column(prefix + (first ? "error" : "error_" + compared.name), errors.back(), truth));
    first = false;
  }
}

/// The errors of what --quantity wants, by quantity, where the truth is known anywhere.
template <int d>
std::vector<std::pair<std::string, ErrorNorms>> norms_of(const Estimation<d>& e, const Truth& truth,
                                                         const EstimateOptions& options) {
  std::vector<std::pair<std::string, ErrorNorms>> result;
  for (const Compared& compared : compared_and_wanted(e, options)) {
    const std::vector<double> errors = known_only(errors_of(compared, e.estimates, truth), truth);
    if (!errors.empty()) result.emplace_back(compared.name, error_norms(errors));
  }
  return result;
}

template <int d>
void run(const EstimateOptions& options, const Shape<d>& shape) {
  const GridStep h{checked("--h", options.h)};
  const std::optional<EuclideanLength> R = radius_of(options, h);
  const SceneSettings<d> settings = scene_settings<d>(options, h);
  std::vector<Estimation<d>> estimations = chosen<d>(options, R);
  const double predicted =
      predicted_memory<d>(estimations, predicted_size(options.shape, shape, settings), h, R, options);
  require_memory(predicted, fmt::format("{} at h = {}", options.shape, h.value));
  SurfelOutput output(options.csv, options.out, d);

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
  if (!output.empty()) {
    SurfelTable table = surfel_table<d>(estimations, scene.surfels, h, {});
    std::vector<std::vector<double>> errors;
    errors.reserve(16 * estimations.size());  // columns point into it
    for (const Estimation<d>& e : estimations) {
      const std::string prefix = title_prefix(estimations, e);
      add_estimates(table, e, prefix, options);
      add_truth(table, e, prefix, truths.at(e.variant->position), errors, options);
    }
    output.write<d>(table, scene.surfels, h);
  }

  const Truth& truth = truths.begin()->second;
  if (options.json) {
    nlohmann::ordered_json json{{"shape", options.shape}};
    json.update(head_json(h, R, scene.surfels.size(), scene.components));
    json.update({{"singular", truth.singular}, {"far", truth.far}, {"truth_residual", truth.worst_residual}});
    for (const Estimation<d>& e : estimations) {
      nlohmann::ordered_json estimate = to_json(e, options);
      for (const auto& [quantity, norms] : norms_of(e, truths.at(e.variant->position), options))
        estimate["errors"][quantity] = to_json(norms);
      json["estimates"].push_back(std::move(estimate));
    }
    return fmt::print("{}\n", json.dump(2));
  }
  std::FILE* out = output.summary_stream();
  say(out, "{} at h = {}{}, {}\n", options.shape, h.value, radius_text(R, h),
      fmt::join(options.estimators, ", "));
  std::string line = fmt::format("surfels {}", scene.surfels.size());
  if (scene.components > 0) line += fmt::format(", components {}", scene.components);
  if (truth.singular > 0) line += fmt::format(", {} at singular points (left out)", truth.singular);
  if (truth.far > 0) line += fmt::format(", {} far from the boundary (left out)", truth.far);
  say(out, "{}; truth residual <= {:.2g} of the size\n", line, truth.worst_residual);
  for (const Estimation<d>& e : estimations) {
    if (estimations.size() > 1) say(out, "{}\n", e.name);
    for (const auto& [quantity, norms] : norms_of(e, truths.at(e.variant->position), options))
      say(out, "error of {:<9} sup {}  rms {}  mean {}\n", quantity, format_error(norms.sup),
          format_error(norms.rms), format_error(norms.mean));
    say_text(out, work_text(e, options, scene.surfels.size()));
  }
  say(out, "{}\n", memory_report(predicted, std::int64_t(scene.surfels.size())));
}

}  // namespace

void estimate_on_shape(const EstimateOptions& options) {
  std::visit(
      [&]<int d>(const std::shared_ptr<const Shape<d>>& shape) {
        if (!options.estimators.empty()) return run<d>(options, *shape);
        EstimateOptions with_default = options;
        with_default.estimators = {estimators_with_quantity<d>(options).front()};
        run<d>(with_default, *shape);
      },
      make_shape(ShapeSpec::parse(options.shape)));
}

}  // namespace gridstep
