#include "experiments/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/core/json_reader.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

/// A list under the plural key. @throws InputError where it is missing or empty.
const nlohmann::json& list(JsonReader& reader, const std::string& key) {
  const nlohmann::json& value = reader.value(key);
  if (!value.is_array() || value.empty()) reader.fail(key, "a list with at least one entry");
  return value;
}

/// Failures of the parsers of shapes and estimators get the place in the file in front.
template <class Function>
auto placed(JsonReader& reader, Function function) {
  try {
    return function();
  } catch (const InputError& error) {
    reader.fail(error.what());
  }
}

bool takes_radius(const std::string& estimator, int dimension) {
  const EstimatorEntry& entry = find_estimator(estimator);
  return dimension == 2 ? entry.variant<2>().takes_radius : entry.variant<3>().takes_radius;
}

bool takes_options(const std::string& estimator, int dimension) {
  const EstimatorEntry& entry = find_estimator(estimator);
  return dimension == 2 ? entry.variant<2>().takes_options() : entry.variant<3>().takes_options();
}

RadiusRule usual_radius(const std::string& estimator, int dimension) {
  const EstimatorEntry& entry = find_estimator(estimator);
  return {dimension == 2 ? entry.variant<2>().usual_k : entry.variant<3>().usual_k, 1.0 / 3.0};
}

Sweep read_sweep(JsonReader& reader) {
  std::vector<ShapeSpec> shapes;
  int dimension = 0;
  for (const nlohmann::json& shape : list(reader, "shapes")) {
    placed(reader, [&] {
      shapes.push_back(ShapeSpec::parse(shape));
      make_shape(shapes.back());
      const int its = find_shape(shapes.back().name).dimension();
      if (dimension != 0 && its != dimension)
        throw InputError(
            fmt::format("shape '{}' is {}D, the ones before are {}D", shapes.back().name, its, dimension));
      dimension = its;
    });
  }
  const std::vector<std::string> estimators = reader.texts("estimators");
  if (estimators.empty()) reader.fail("estimators", "a list with at least one entry");
  for (const std::string& name : estimators)
    placed(reader, [&] {
      const EstimatorEntry& entry = find_estimator(name);
      dimension == 2 ? void(entry.variant<2>()) : void(entry.variant<3>());
    });
  std::vector<Evaluation> evaluations{EstimatorOptions{}.evaluation};
  if (reader.has("evaluations")) {
    evaluations.clear();
    for (const std::string& name : reader.texts("evaluations"))
      placed(reader, [&] { evaluations.push_back(parse_evaluation(name)); });
    if (evaluations.empty()) reader.fail("evaluations", "a list with at least one entry");
  }
  for (const std::string& name : estimators)
    if (takes_options(name, dimension))
      for (const Evaluation evaluation : evaluations)
        placed(reader, [&] {
          const EstimatorEntry& entry = find_estimator(name);
          dimension == 2 ? entry.variant<2>().require(evaluation, name)
                         : entry.variant<3>().require(evaluation, name);
        });
  std::vector<RadiusRule> radii;
  const bool any_radius = std::any_of(estimators.begin(), estimators.end(),
                                      [&](const std::string& name) { return takes_radius(name, dimension); });
  if (!any_radius)
    for (const char* key : {"radii", "evaluations", "centre"})
      if (reader.has(key)) reader.fail(key, "left out: no estimator here takes a radius");
  if (reader.has("radii"))
    for (JsonReader& radius : reader.objects("radii")) {
      radii.push_back({radius.number("k"), radius.number("alpha", 1.0 / 3.0)});
      if (!(radii.back().k > 0)) radius.fail("k", "positive");
      if (!(radii.back().alpha >= 0 && radii.back().alpha < 1)) radius.fail("alpha", "in [0, 1)");
      radius.finish();
    }
  if (reader.has("radii") && radii.empty()) reader.fail("radii", "a list with at least one entry");
  std::vector<double> noise{0};
  if (reader.has("noise")) noise = reader.numbers("noise");
  for (const double beta : noise)
    if (!(beta >= 0 && beta < 1)) reader.fail("noise", "a list of numbers in [0, 1)");
  if (noise.empty()) reader.fail("noise", "a list with at least one entry");

  JsonReader schedule = reader.object("schedule");
  Sweep sweep{std::move(shapes), estimators,          std::move(evaluations),  std::move(radii),
              std::move(noise),  KernelCentre::spels, Schedule::read(schedule)};
  const std::string centre = reader.text("centre", "spels");
  placed(reader, [&] { sweep.centre = parse_kernel_centre(centre); });
  sweep.shifts = reader.integer("shifts", 10);
  if (sweep.shifts < 1 || sweep.shifts > 10000) reader.fail("shifts", "from 1 to 10000");
  sweep.rotate = reader.boolean("rotate", false);
  reader.finish();
  for (const Method& method : sweep.methods())
    for (const double h : sweep.schedule.values())
      if (const auto& rule = method.radius; rule && to_digital(rule->at({h}), {h}).value < 1)
        reader.fail(fmt::format("h = {:.6g} with k = {:.6g}, alpha = {:.6g}: R/h = {:.6g} must be at least 1",
                                h, rule->k, rule->alpha, to_digital(rule->at({h}), {h}).value));
  return sweep;
}

}  // namespace

bool Method::agrees_with(const Method& other) const {
  return estimator == other.estimator && radius == other.radius;
}

std::vector<Method> Sweep::methods() const {
  std::vector<Method> result;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, radii.size()); ++i)
    for (const std::string& name : estimators) {
      const auto radius = [&] { return radii.empty() ? usual_radius(name, dimension()) : radii[i]; };
      if (takes_options(name, dimension())) {
        for (const Evaluation evaluation : evaluations) result.push_back({name, radius(), evaluation});
      } else if (takes_radius(name, dimension())) {
        result.push_back({name, radius(), std::nullopt});
      } else if (i == 0) {
        result.push_back({name, std::nullopt, std::nullopt});
      }
    }
  return result;
}

int Sweep::dimension() const {
  return find_shape(shapes.front().name).dimension();
}

Study Study::read(const nlohmann::json& json, const std::string& source) {
  JsonReader reader(json, source);
  Study study;
  study.name = reader.text("name");
  if (study.name.empty() || study.name.find('/') != std::string::npos)
    reader.fail("name", "a name without slashes");
  study.description = reader.text("description", "");
  study.seed = reader.seed("seed", 1);
  study.timing = reader.boolean("timing", false);
  study.tables = {study.timing ? "cost" : "convergence"};
  if (reader.has("tables")) study.tables = reader.texts("tables");
  for (const std::string& table : study.tables)
    if (table != "convergence" && table != "cost" && table != "work-precision" && table != "equal-error" &&
        table != "best-radius" && table != "noise" && table != "isotropy")
      reader.fail("tables",
                  "a list of convergence, cost, work-precision, equal-error, best-radius, noise, isotropy");
  for (JsonReader& sweep : reader.objects("sweeps")) study.sweeps.push_back(read_sweep(sweep));
  if (study.sweeps.empty()) reader.fail("sweeps", "a list with at least one entry");
  reader.finish();
  return study;
}

}  // namespace gridstep
