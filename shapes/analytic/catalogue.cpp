#include "shapes/analytic/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gridstep {

#define GRIDSTEP_SHAPE(id) ShapeEntry describe_##id();
#include "shapes/analytic/catalogue.inc"
#undef GRIDSTEP_SHAPE

namespace {

std::vector<Parameter> centre_parameters(int dimension) {
  std::vector<Parameter> result{Parameter::number("cx", 0, "length", "centre, x"),
                                Parameter::number("cy", 0, "length", "centre, y")};
  if (dimension == 3) result.push_back(Parameter::number("cz", 0, "length", "centre, z"));
  return result;
}

std::vector<ShapeEntry> build_catalogue() {
  std::vector<ShapeEntry> entries{
#define GRIDSTEP_SHAPE(id) describe_##id(),
#include "shapes/analytic/catalogue.inc"
#undef GRIDSTEP_SHAPE
  };
  for (ShapeEntry& entry : entries)
    for (Parameter& parameter : centre_parameters(entry.dimension()))
      entry.parameters.push_back(std::move(parameter));
  return entries;
}

template <int d>
std::shared_ptr<const Shape<d>> make(const ShapeFactory<d>& factory, const ParameterValues& values) {
  RealPoint<d> centre;
  const char* const names[] = {"cx", "cy", "cz"};
  for (int k = 0; k < d; ++k) centre[k] = values[names[k]];
  return factory(values, centre);
}

}  // namespace

const std::vector<ShapeEntry>& shape_catalogue() {
  static const std::vector<ShapeEntry> entries = build_catalogue();
  return entries;
}

const ShapeEntry& find_shape(const std::string& name) {
  for (const ShapeEntry& entry : shape_catalogue())
    if (entry.name == name) return entry;
  std::string known;
  for (const ShapeEntry& entry : shape_catalogue()) known += (known.empty() ? "" : ", ") + entry.name;
  throw InputError(fmt::format("unknown shape '{}'; known: {}", name, known));
}

AnyShape make_shape(const ShapeSpec& spec) {
  const ShapeEntry& entry = find_shape(spec.name);
  const ParameterValues values(spec, entry.parameters);
  return std::visit([&](const auto& factory) -> AnyShape { return make(factory, values); }, entry.make);
}

template <int d>
std::shared_ptr<const Shape<d>> make_shape(const std::string& text) {
  AnyShape shape = make_shape(ShapeSpec::parse(text));
  if (auto* found = std::get_if<std::shared_ptr<const Shape<d>>>(&shape)) return std::move(*found);
  throw InputError(fmt::format("shape '{}' is not a {}D shape", text, d));
}

template std::shared_ptr<const Shape<2>> make_shape<2>(const std::string&);
template std::shared_ptr<const Shape<3>> make_shape<3>(const std::string&);

}  // namespace gridstep
