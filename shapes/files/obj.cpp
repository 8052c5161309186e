#include <fmt/format.h>

#include <algorithm>

#include "shapes/files/surface_file.hpp"

namespace gridstep {

void write_obj(const SurfelTable& table, const QuadMesh& mesh, const Sink& sink) {
  const auto value = std::find_if(table.values.begin(), table.values.end(),
                                  [](const SurfelColumn& c) { return c.type == SurfelColumn::Type::real; });
  const bool has_value = value != table.values.end();
  if (has_value) sink(fmt::format("# vt: {} of each face\n", value->title));
  for (const auto& v : mesh.vertices) sink(fmt::format("v {} {} {}\n", v[0], v[1], v[2]));
  if (has_value)
    for (std::size_t i = 0; i < table.rows; ++i) sink(fmt::format("vt {} 0\n", value->value(i)));
  for (std::size_t i = 0; i < table.rows; ++i) {
    std::string face = "f";
    for (const std::int32_t vertex : mesh.quads[i])
      face += has_value ? fmt::format(" {}/{}", vertex + 1, i + 1) : fmt::format(" {}", vertex + 1);
    sink(face + "\n");
  }
}

}  // namespace gridstep
