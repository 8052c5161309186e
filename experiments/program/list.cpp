#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "estimators/catalogue.hpp"
#include "experiments/catalogue.hpp"
#include "experiments/program/commands.hpp"
#include "experiments/program/say.hpp"
#include "shapes/analytic/catalogue.hpp"

namespace gridstep {

namespace {

using nlohmann::ordered_json;

ordered_json value_json(const std::variant<double, std::string>& value) {
  return std::visit([](const auto& v) { return ordered_json(v); }, value);
}

ordered_json shapes_json() {
  ordered_json result = ordered_json::array();
  for (const ShapeEntry& entry : shape_catalogue()) {
    ordered_json parameters = ordered_json::array();
    for (const Parameter& p : entry.parameters)
      parameters.push_back({{"name", p.name},
                            {"default", value_json(p.default_value)},
                            {"unit", p.unit},
                            {"meaning", p.meaning}});
    result.push_back({{"name", entry.name},
                      {"dimension", entry.dimension()},
                      {"summary", entry.summary},
                      {"parameters", parameters}});
  }
  return result;
}

template <int d>
ordered_json quantities_json(const std::optional<EstimatorEntry::Variant<d>>& variant) {
  ordered_json names = ordered_json::array();
  if (variant)
    for (const Quantity& quantity : variant->quantities) names.push_back(quantity.name);
  return names;
}

bool takes_radius(const EstimatorEntry& entry) {
  return entry.in_2d ? entry.in_2d->takes_radius : entry.in_3d->takes_radius;
}

template <class Variant>
ordered_json usual_k(const std::optional<Variant>& variant) {
  return variant && variant->takes_radius ? ordered_json(variant->usual_k) : ordered_json();
}

std::string radius_text(const EstimatorEntry& entry) {
  if (!takes_radius(entry)) return "no radius";
  std::string usual;
  const auto add = [&usual](const char* dimension, const auto& variant) {
    if (variant) usual += fmt::format("{}{} in {}", usual.empty() ? "" : ", ", variant->usual_k, dimension);
  };
  add("2D", entry.in_2d);
  add("3D", entry.in_3d);
  return fmt::format("takes a radius (usual k: {})", usual);
}

const char* values_at(const EstimatorEntry& entry) {
  return entry.in_2d && entry.in_2d->position == ValuePosition::start_pointel ? "start pointel"
                                                                              : "surfel centre";
}

ordered_json estimators_json() {
  ordered_json result = ordered_json::array();
  for (const EstimatorEntry& entry : estimator_catalogue())
    result.push_back({{"name", entry.name},
                      {"summary", entry.summary},
                      {"quantities_2d", quantities_json(entry.in_2d)},
                      {"quantities_3d", quantities_json(entry.in_3d)},
                      {"takes_radius", takes_radius(entry)},
                      {"usual_k_2d", usual_k(entry.in_2d)},
                      {"usual_k_3d", usual_k(entry.in_3d)},
                      {"values_at", values_at(entry)},
                      {"built", entry.not_built.empty()}});
  return result;
}

ordered_json studies_json() {
  ordered_json result = ordered_json::array();
  for (const StudyEntry& entry : study_catalogue())
    result.push_back({{"name", entry.name},
                      {"summary", entry.summary},
                      {"quick", ordered_json::parse(entry.quick)},
                      {"full", ordered_json::parse(entry.full)}});
  return result;
}

void print_shapes() {
  say(stdout, "Shapes (name:parameter=default,...; every shape also takes a centre cx, cy and, in 3D, cz)\n");
  for (const ShapeEntry& entry : shape_catalogue()) {
    say(stdout, "  {:<13} {}D  {}\n", entry.name, entry.dimension(), entry.summary);
    for (const Parameter& p : entry.parameters) {
      if (p.name == "cx" || p.name == "cy" || p.name == "cz") continue;
      const std::string value =
          std::visit([](const auto& v) { return fmt::format("{}", v); }, p.default_value);
      say(stdout, "  {:<17}  {} = {}  ({}) {}\n", "", p.name, value, p.unit, p.meaning);
    }
  }
}

void print_estimators() {
  say(stdout, "Estimators\n");
  for (const EstimatorEntry& entry : estimator_catalogue()) {
    say(stdout, "  {:<18} {}\n", entry.name, entry.summary);
    const auto print_quantities = [](const char* dimension, const auto& variant) {
      if (!variant) return;
      std::string names;
      for (const Quantity& quantity : variant->quantities) names += " " + quantity.name;
      say(stdout, "  {:<18}   {}:{}\n", "", dimension, names);
    };
    print_quantities("2D", entry.in_2d);
    print_quantities("3D", entry.in_3d);
    say(stdout, "  {:<18}   {}, values at the {}\n", "", radius_text(entry), values_at(entry));
    if (!entry.not_built.empty()) say(stdout, "  {:<18}   not in this build: {}\n", "", entry.not_built);
  }
}

void print_studies() {
  say(stdout, "Studies (their JSON: gridstep list studies --json)\n");
  for (const StudyEntry& entry : study_catalogue()) say(stdout, "  {:<18} {}\n", entry.name, entry.summary);
}

}  // namespace

void add_list_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("list", "What there is: shapes, estimators, studies");
  struct Options {
    std::string what;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  command->add_option("what", options->what, "shapes, estimators or studies; all without it")
      ->check(CLI::IsMember({"shapes", "estimators", "studies"}));
  command->add_flag("--json", options->json, "As JSON, for other programs");
  command->footer("Example:\n  gridstep list shapes");
  command->callback([options] {
    const bool all = options->what.empty();
    const auto wanted = [&](const char* what) { return all || options->what == what; };
    if (options->json) {
      ordered_json result = ordered_json::object();
      if (wanted("shapes")) result["shapes"] = shapes_json();
      if (wanted("estimators")) result["estimators"] = estimators_json();
      if (wanted("studies")) result["studies"] = studies_json();
      fmt::print("{}\n", result.dump(2));
      return;
    }
    if (wanted("shapes")) print_shapes();
    if (wanted("estimators")) print_estimators();
    if (wanted("studies")) print_studies();
  });
}

}  // namespace gridstep
