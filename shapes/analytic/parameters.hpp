#pragma once

#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

namespace gridstep {

/// What a parameter of a shape is: its documentation and its validity in one place.
struct Parameter {
  std::string name;
  std::variant<double, std::string> default_value;  ///< the alternative says which kind of value is expected
  std::string unit;                                 ///< "length", "radian", "1" or "text"
  std::string meaning;
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool least_excluded = false;
  bool integer = false;

  /// A length that must be positive.
  static Parameter length(std::string name, double default_value, std::string meaning) {
    return {name, default_value, "length", meaning, 0.0, std::numeric_limits<double>::infinity(), true};
  }
  /// A coordinate, an angle or another number without bounds.
  static Parameter number(std::string name, double default_value, std::string unit, std::string meaning) {
    return {name, default_value, unit, meaning};
  }
  /// A count of at least `least`.
  static Parameter count(std::string name, int default_value, int least, std::string meaning) {
    return {name, double(default_value), "1", meaning, double(least), 1e6, false, true};
  }
};

/// A shape as a user names it: a name and values that may be incomplete.
struct ShapeSpec {
  std::string name;
  std::map<std::string, std::variant<double, std::string>> values;

  /// "ellipse:a=20,b=7,angle=0.3", or with values in the order of the shape's parameters, "ellipse:20,7,0.3".
  /// @throws InputError naming the text and what is wrong with it.
  static ShapeSpec parse(const std::string& text);
  static ShapeSpec parse(const char* text) { return parse(std::string(text)); }
  /// {"name": "ellipse", "a": 20, "b": 7}.
  static ShapeSpec parse(const nlohmann::json& object);
  /// With every parameter, defaults included (but for a centre at the origin), in the order of the catalogue:
  /// one text for one shape.
  std::string canonical() const;
};

/// The complete, validated values from which a shape is made.
class ParameterValues {
 public:
  /// Fills in defaults. @throws InputError naming the shape, the parameter and the value that is unknown or
  /// invalid.
  ParameterValues(const ShapeSpec& spec, const std::vector<Parameter>& parameters);

  double operator[](const std::string& name) const;
  const std::string& text(const std::string& name) const;

  /// For conditions between parameters: throws InputError "shape: what" with the values of the parameters
  /// named.
  void require(bool holds, const std::string& what) const;

 private:
  std::string shape_;
  std::map<std::string, std::variant<double, std::string>> values_;
};

}  // namespace gridstep
