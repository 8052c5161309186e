#include "shapes/analytic/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string display(const std::variant<double, std::string>& value) {
  const double* number = std::get_if<double>(&value);
  return number ? fmt::format("{}", *number) : std::get<std::string>(value);
}

const Parameter* find_parameter(const std::vector<Parameter>& parameters, const std::string& name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

std::string valid_range(const Parameter& parameter) {
  std::string range = parameter.integer ? "an integer" : "a finite number";
  if (std::isfinite(parameter.least))
    range += fmt::format(" {} {}", parameter.least_excluded ? ">" : ">=", parameter.least);
  if (std::isfinite(parameter.greatest)) range += fmt::format(" <= {}", parameter.greatest);
  return range;
}

bool is_valid(const Parameter& parameter, double value) {
  return std::isfinite(value) && value >= parameter.least && value <= parameter.greatest &&
         !(parameter.least_excluded && value == parameter.least) &&
         !(parameter.integer && value != std::round(value));
}

}  // namespace

ShapeSpec ShapeSpec::parse(const std::string& text) {
  const std::size_t colon = text.find(':');
  ShapeSpec spec{text.substr(0, colon), {}};
  const std::vector<Parameter>& parameters = find_shape(spec.name).parameters;
  if (colon == std::string::npos) return spec;

  std::size_t position = 0;
  for (std::size_t begin = colon + 1; begin <= text.size(); ++position) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equals = item.find('=');
    if (item.empty() || equals == 0)
      throw InputError(fmt::format("shape '{}': expected name=value, not '{}'", text, item));
    if (equals == std::string::npos && position >= parameters.size())
      throw InputError(fmt::format("shape '{}': too many values at '{}'", text, item));
    const std::string name = equals == std::string::npos ? parameters[position].name : item.substr(0, equals);
    const std::string value = equals == std::string::npos ? item : item.substr(equals + 1);
    const Parameter* parameter = find_parameter(parameters, name);
    const bool wants_text = parameter && std::holds_alternative<std::string>(parameter->default_value);
    const std::optional<double> number = wants_text ? std::nullopt : parse_number(value);
    if (!wants_text && !number)
      throw InputError(fmt::format("shape '{}': {} = '{}' is not a number", text, name, value));
    const bool is_new =
        wants_text ? spec.values.emplace(name, value).second : spec.values.emplace(name, *number).second;
    if (!is_new) throw InputError(fmt::format("shape '{}': {} is given twice", text, name));
  }
  return spec;
}

ShapeSpec ShapeSpec::parse(const nlohmann::json& object) {
  if (object.is_string()) return parse(object.get<std::string>());
  if (!object.is_object() || !object.contains("name") || !object["name"].is_string())
    throw InputError("shape: expected an object with a \"name\", not " + object.dump());
  ShapeSpec spec{object["name"].get<std::string>(), {}};
  for (const auto& [key, value] : object.items()) {
    if (key == "name") continue;
    if (value.is_number())
      spec.values.emplace(key, value.get<double>());
    else if (value.is_string())
      spec.values.emplace(key, value.get<std::string>());
    else
      throw InputError(
          fmt::format("shape '{}': {} = {} is neither a number nor a text", spec.name, key, value.dump()));
  }
  return spec;
}

std::string ShapeSpec::canonical() const {
  const std::vector<Parameter>& parameters = find_shape(name).parameters;
  std::string result = name;
  char separator = ':';
  for (const Parameter& parameter : parameters) {
    const auto given = values.find(parameter.name);
    const auto& value = given == values.end() ? parameter.default_value : given->second;
    const bool is_centre = parameter.name == "cx" || parameter.name == "cy" || parameter.name == "cz";
    if (is_centre && value == parameter.default_value) continue;
    result += fmt::format("{}{}={}", separator, parameter.name, display(value));
    separator = ',';
  }
  return result;
}

ParameterValues::ParameterValues(const ShapeSpec& spec, const std::vector<Parameter>& parameters)
    : shape_(spec.name) {
  for (const auto& [name, value] : spec.values) {
    const Parameter* parameter = find_parameter(parameters, name);
    if (!parameter) {
      std::string known;
      for (const Parameter& p : parameters) known += (known.empty() ? "" : ", ") + p.name;
      throw InputError(fmt::format("shape '{}' has no parameter '{}'; it has: {}", shape_, name, known));
    }
    const bool is_text = std::holds_alternative<std::string>(value);
    if (is_text != std::holds_alternative<std::string>(parameter->default_value))
      throw InputError(fmt::format("shape '{}': {} = '{}' must be a {}", shape_, name, display(value),
                                   is_text ? "number" : "text"));
    if (!is_text && !is_valid(*parameter, std::get<double>(value)))
      throw InputError(fmt::format("shape '{}': {} = {} must be {}", shape_, name, display(value),
                                   valid_range(*parameter)));
    values_[name] = value;
  }
  for (const Parameter& parameter : parameters) values_.emplace(parameter.name, parameter.default_value);
}

double ParameterValues::operator[](const std::string& name) const {
  return std::get<double>(values_.at(name));
}

const std::string& ParameterValues::text(const std::string& name) const {
  return std::get<std::string>(values_.at(name));
}

void ParameterValues::require(bool holds, const std::string& what) const {
  if (holds) return;
  std::string given;
  for (const auto& [name, value] : values_)
    if (name != "cx" && name != "cy" && name != "cz") given += fmt::format(" {}={}", name, display(value));
  throw InputError(fmt::format("shape '{}': {}, not{}", shape_, what, given));
}

}  // namespace gridstep
