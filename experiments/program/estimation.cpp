#include "experiments/program/estimation.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "estimators/contour/digital_contour.hpp"
#include "experiments/core/text.hpp"
#include "experiments/memory.hpp"
#include "experiments/record.hpp"

namespace gridstep {

namespace {

SurfelColumn real_column(std::string title, const std::vector<double>& values) {
  return {std::move(title), SurfelColumn::Type::real, [&values](std::size_t i) { return values[i]; }};
}

/// px, py: the pointels at which linels start.
void add_pointel_columns(std::vector<SurfelColumn>& columns, std::span<const Surfel<2>> linels) {
  for (int k = 0; k < 2; ++k)
    columns.push_back({std::string("p") + "xy"[k], SurfelColumn::Type::integer, [linels, k](std::size_t i) {
                         return pointel<2>(start_pointel(linels[i])).coordinates[k];
                       }});
}

}  // namespace

double checked(const char* option, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw InputError(fmt::format("{} = {}: must be a positive finite number", option, value));
  return value;
}

std::optional<EuclideanLength> radius_of(const EstimateOptions& options, GridStep h) {
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

bool wanted(const EstimateOptions& options, const std::string& column) {
  const std::string& quantity = options.quantity;
  return quantity.empty() || column == quantity || column.substr(0, column.find('_')) == quantity;
}

template <int d>
std::vector<std::string> estimators_with_quantity(const EstimateOptions& options) {
  std::vector<std::string> names;
  for (const EstimatorEntry& entry : estimator_catalogue()) {
    const auto& variant = [&]() -> const auto& {
      if constexpr (d == 2)
        return entry.in_2d;
      else
        return entry.in_3d;
    }
    ();
    if (variant && entry.not_built.empty() && std::any_of(variant->quantities.begin(), variant->quantities.end(),
                               [&](const Quantity& q) { return wanted(options, q.name); }))
      names.push_back(entry.name);
  }
  if (names.empty())
    throw InputError(fmt::format("--quantity {}: no estimator in {}D has it (see gridstep list estimators)",
                                 options.quantity, d));
  return names;
}

template <int d>
std::vector<Estimation<d>> chosen(const EstimateOptions& options, const std::optional<EuclideanLength>& R) {
  std::vector<Estimation<d>> result;
  bool radius_used = false;
  for (const std::string& name : options.estimators) {
    const auto& variant = find_estimator(name).variant<d>();
    std::string known;
    for (const Quantity& quantity : variant.quantities) known += " " + quantity.name;
    if (std::none_of(variant.quantities.begin(), variant.quantities.end(),
                     [&](const Quantity& q) { return wanted(options, q.name); }))
      throw InputError(fmt::format("--quantity {}: estimator '{}' has{}", options.quantity, name, known));
    if (variant.takes_radius && !R)
      throw InputError(fmt::format("estimator '{}' needs one of --radius and --k (usual: --k {:.4g})", name,
                                   variant.usual_k));
    if (variant.takes_options()) variant.require(parse_evaluation(options.evaluation), name);
    radius_used |= variant.takes_radius;
    result.push_back({name, &variant, {}, {}, {}, 0, 0});
  }
  if ((options.has_radius || options.has_k) && !radius_used)
    throw InputError(fmt::format("--{}: estimator '{}' takes no radius", options.has_radius ? "radius" : "k",
                                 options.estimators.front()));
  parse_evaluation(options.evaluation);
  parse_kernel_centre(options.centre);
  return result;
}

template <int d>
double predicted_memory(const std::vector<Estimation<d>>& estimations, SetSize size, GridStep h,
                        const std::optional<EuclideanLength>& R, const EstimateOptions& options) {
  const Evaluation evaluation = parse_evaluation(options.evaluation);
  double bytes = size.bytes, tables = 0;
  for (const Estimation<d>& e : estimations) {
    const bool moments = d == 3 && e.variant->quantities.size() > 1;
    bytes += size.surfels * predicted_surfel_memory(moments);
    if (R && e.variant->takes_options())
      tables = std::max(tables, predicted_table_memory<d>(*e.variant, to_digital(*R, h), evaluation,
                                                          tbb::this_task_arena::max_concurrency()));
  }
  return bytes + tables;
}

template <int d>
void evaluate(std::vector<Estimation<d>>& estimations, const DigitalSet<d>& set,
              std::span<const Surfel<d>> surfels, GridStep h, EuclideanLength R,
              const EstimateOptions& options) {
  const EstimatorOptions how{parse_evaluation(options.evaluation), parse_kernel_centre(options.centre),
                             options.quantity};
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

template <int d>
SurfelTable surfel_table(const std::vector<Estimation<d>>& estimations, std::span<const Surfel<d>> surfels,
                         GridStep h, std::span<const std::size_t> component_begin) {
  SurfelTable table{surfels.size(), cell_columns(surfels), {}};
  if constexpr (d == 2)
    if (std::any_of(estimations.begin(), estimations.end(), [](const Estimation<2>& e) {
          return e.variant->position == ValuePosition::start_pointel;
        }))
      add_pointel_columns(table.keys, surfels);
  for (SurfelColumn& column : centre_columns(surfels, h)) table.keys.push_back(std::move(column));
  if (!component_begin.empty())
    table.values.push_back({"component", SurfelColumn::Type::integer, [component_begin](std::size_t i) {
                              const auto behind =
                                  std::upper_bound(component_begin.begin(), component_begin.end(), i);
                              return double(behind - component_begin.begin() - 1);
                            }});
  return table;
}

template <int d>
void add_estimates(SurfelTable& table, const Estimation<d>& e, const std::string& prefix,
                   const EstimateOptions& options) {
  for (std::size_t q = 0; q < e.estimates.quantities.size(); ++q)
    if (wanted(options, e.estimates.quantities[q]))
      table.values.push_back(real_column(prefix + e.estimates.quantities[q], e.estimates.columns[q]));
  for (std::size_t q = 0; q < e.raw.quantities.size(); ++q)
    table.values.push_back(real_column(prefix + e.raw.quantities[q], e.raw.columns[q]));
}

template <int d>
std::string work_text(const Estimation<d>& e, const EstimateOptions& options, std::size_t surfels) {
  const EstimatorWork& work = e.work;
  std::string text;
  if (e.variant->takes_options()) {
    text = fmt::format("{}: {} kernel evaluations, {} cells visited, {} restarts; kernel of {} cells",
                       options.evaluation, work.evaluations, work.cells_visited, work.restarts,
                       work.kernel_size);
    if (!work.mask_sizes.empty()) {
      const auto [least, most] = std::minmax_element(work.mask_sizes.begin(), work.mask_sizes.end());
      text += fmt::format(", {} masks that gain (and lose) {} to {}", work.mask_sizes.size(), *least, *most);
    }
    if (work.fallbacks > 0) text += fmt::format(", {} of {} surfels by a fallback", work.fallbacks, surfels);
    text += "\n";
  }
  return text + fmt::format("init {}, evaluation {} ({:.0f} ns a surfel)\n", format_seconds(e.seconds_init),
                            format_seconds(e.seconds_eval), 1e9 * e.seconds_eval / double(surfels));
}

nlohmann::ordered_json head_json(GridStep h, const std::optional<EuclideanLength>& R, std::size_t surfels,
                                 std::size_t components) {
  nlohmann::ordered_json json{{"h", h.value}};
  if (R) json.update({{"radius", R->value}, {"digital_radius", to_digital(*R, h).value}});
  json["surfels"] = surfels;
  if (components > 0) json["components"] = components;  // else they were not counted
  return json;
}

template <int d>
nlohmann::ordered_json to_json(const Estimation<d>& e, const EstimateOptions& options) {
  nlohmann::ordered_json ranges = nlohmann::ordered_json::object();
  for (std::size_t q = 0; q < e.estimates.quantities.size(); ++q) {
    const std::vector<double>& column = e.estimates.columns[q];
    if (!wanted(options, e.estimates.quantities[q]) || column.empty()) continue;
    const auto [least, most] = std::minmax_element(column.begin(), column.end());
    ranges[e.estimates.quantities[q]] = {*least, *most};
  }
  nlohmann::ordered_json json{{"estimator", e.name}, {"ranges", ranges}};
  if (e.variant->takes_radius) {
    json["evaluation"] = options.evaluation;
    json["work"] = to_json(e.work);
  }
  json["seconds"] = {{"init", e.seconds_init}, {"eval", e.seconds_eval}};
  return json;
}

std::string radius_text(const std::optional<EuclideanLength>& R, GridStep h) {
  return R ? fmt::format(", R = {:.6g} (R/h = {:.6g})", R->value, to_digital(*R, h).value) : "";
}

#define GRIDSTEP_INSTANTIATE(d)                                                                              \
  template std::vector<std::string> estimators_with_quantity<d>(const EstimateOptions&);                     \
  template std::vector<Estimation<d>> chosen(const EstimateOptions&, const std::optional<EuclideanLength>&); \
  template double predicted_memory(const std::vector<Estimation<d>>&, SetSize, GridStep,                     \
                                   const std::optional<EuclideanLength>&, const EstimateOptions&);           \
  template void evaluate(std::vector<Estimation<d>>&, const DigitalSet<d>&, std::span<const Surfel<d>>,      \
                         GridStep, EuclideanLength, const EstimateOptions&);                                 \
  template SurfelTable surfel_table(const std::vector<Estimation<d>>&, std::span<const Surfel<d>>, GridStep, \
                                    std::span<const std::size_t>);                                           \
  template void add_estimates(SurfelTable&, const Estimation<d>&, const std::string&,                        \
                              const EstimateOptions&);                                                       \
  template std::string work_text(const Estimation<d>&, const EstimateOptions&, std::size_t);                 \
  template nlohmann::ordered_json to_json(const Estimation<d>&, const EstimateOptions&);
GRIDSTEP_INSTANTIATE(2)
GRIDSTEP_INSTANTIATE(3)
#undef GRIDSTEP_INSTANTIATE

}  // namespace gridstep
