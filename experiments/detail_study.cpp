#include "experiments/detail_study.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "estimators/catalogue.hpp"
#include "experiments/core/json_reader.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

void read_input(JsonReader& detail, DetailStudy& study) {
  if (detail.has("shape") == detail.has("volume")) detail.fail("one of 'shape' and 'volume' is needed");
  if (detail.has("volume")) {
    study.volume = detail.text("volume");
    study.h = detail.number("h", 0);
    if (detail.has("threshold")) {
      const std::vector<double> bounds = detail.numbers("threshold");
      if (bounds.size() != 2 || !(bounds[0] <= bounds[1]))
        detail.fail("threshold", "[low, high] with low <= high");
      study.threshold = {bounds[0], bounds[1]};
    }
  } else {
    try {
      study.shape = ShapeSpec::parse(detail.value("shape"));
      if (find_shape(study.shape->name).dimension() != 3)
        throw InputError("shape '" + study.shape->name + "' is not 3D");
      make_shape(*study.shape);
    } catch (const InputError& error) {
      detail.fail(error.what());
    }
    study.h = detail.number("h");
  }
  if (detail.has("h") && !(study.h > 0)) detail.fail("h", "positive");
}

}  // namespace

bool DetailStudy::is(const nlohmann::json& json) {
  return json.is_object() && json.contains("detail");
}

DetailStudy DetailStudy::read(const nlohmann::json& json, const std::string& source) {
  JsonReader reader(json, source);
  DetailStudy study;
  study.name = reader.text("name");
  study.description = reader.text("description", "");
  JsonReader detail = reader.object("detail");
  read_input(detail, study);
  study.estimator = detail.text("estimator", "ii-covariance");
  bool takes_radius = false;
  try {
    takes_radius = find_estimator(study.estimator).variant<3>().takes_radius;
  } catch (const InputError& error) {
    detail.fail(error.what());
  }
  if (!takes_radius) detail.fail("estimator", "one that takes a radius");
  study.digital_radii = detail.numbers("digital_radii");
  std::vector<double> sorted = study.digital_radii;
  std::sort(sorted.begin(), sorted.end());
  if (sorted.empty() || !(sorted.front() >= 1) ||
      std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    detail.fail("digital_radii", "a list of different numbers, R/h, of at least 1");
  detail.finish();
  reader.finish();
  return study;
}

}  // namespace gridstep
