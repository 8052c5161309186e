#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shapes/analytic/catalogue.hpp"

namespace gridstep {

/// A study of one surface at several radii. A volume has no truth, so these are values, where a Study has errors.
struct DetailStudy {
  std::string name, description;
  std::optional<ShapeSpec> shape;  ///< in 3D, digitized at h; else the volume is read
  double h = 0;                    ///< of a volume: 0 for the spacing in the file
  std::string volume;
  std::optional<std::pair<double, double>> threshold;  ///< of a volume: grey values of the foreground
  std::string estimator;                               ///< one that takes a radius
  std::vector<double> digital_radii;                   ///< R/h, all different, as given

  /// Whether the JSON is of this kind rather than a Study.
  static bool is(const nlohmann::json& json);

  /// From JSON as documented in results/README.md. All but the volume itself is checked here.
  /// @throws InputError naming the source, the place, the key and the value.
  static DetailStudy read(const nlohmann::json& json, const std::string& source);
};

}  // namespace gridstep
