#include "experiments/core/schedule.hpp"

#include <fmt/format.h>

#include <cmath>

#include "experiments/core/json_reader.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

void require(bool holds, const char* key, double value, const std::string& requirement) {
  if (!holds) throw InputError(fmt::format("{} = {} must be {}", key, value, requirement));
}

bool is_step(double value) {
  return value > 0 && std::isfinite(value);
}

}  // namespace

Schedule Schedule::geometric(double from, double to, int steps) {
  const std::string positive = "a positive, finite number";
  require(is_step(from), "from", from, positive);
  require(is_step(to), "to", to, positive);
  require(to < from, "to", to, fmt::format("less than from = {}: steps go from coarse to fine", from));
  require(steps >= 2 && steps <= 10000, "steps", steps, "from 2 to 10000");

  std::vector<double> values;
  for (int i = 0; i < steps; ++i) values.push_back(from * std::pow(to / from, double(i) / (steps - 1)));
  values.back() = to;
  return Schedule(std::move(values));
}

Schedule Schedule::papers(int first, int last) {
  require(std::abs(first) <= 1000, "first", first, "from -1000 to 1000");
  require(std::abs(last) <= 1000, "last", last, "from -1000 to 1000");
  require(first < last, "last", last, fmt::format("greater than first = {}", first));

  std::vector<double> values;
  for (int j = first; j <= last; ++j) values.push_back(std::exp(-j / 10.0));
  return Schedule(std::move(values));
}

Schedule Schedule::of(std::vector<double> values) {
  if (values.empty()) throw InputError("values = [] must have at least one grid step");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string key = fmt::format("values[{}]", i);
    require(is_step(values[i]), key.c_str(), values[i], "a positive, finite number");
    if (i > 0)
      require(values[i] < values[i - 1], key.c_str(), values[i],
              fmt::format("less than values[{}] = {}", i - 1, values[i - 1]));
  }
  return Schedule(std::move(values));
}

Schedule Schedule::read(JsonReader& reader) {
  const auto checked = [](JsonReader& place, const auto& make) {
    place.finish();
    try {
      return make();
    } catch (const InputError& error) {
      place.fail(error.what());
    }
  };
  if (reader.has("papers")) {
    reader.finish();
    JsonReader papers = reader.object("papers");
    const int first = papers.integer("first"), last = papers.integer("last");
    return checked(papers, [&] { return Schedule::papers(first, last); });
  }
  if (reader.has("values")) {
    const std::vector<double> values = reader.numbers("values");
    return checked(reader, [&] { return of(values); });
  }
  const double from = reader.number("from"), to = reader.number("to");
  const int steps = reader.integer("steps");
  return checked(reader, [&] { return geometric(from, to, steps); });
}

}  // namespace gridstep
