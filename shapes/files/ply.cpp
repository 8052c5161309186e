#include <fmt/format.h>

#include <iterator>

#include "shapes/files/surface_file.hpp"

namespace gridstep {

void write_ply(const SurfelTable& table, const QuadMesh& mesh, const Sink& sink) {
  std::string header = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar int vertex_indices\n",
      mesh.vertices.size(), mesh.quads.size());
  for (const SurfelColumn& column : table.values)
    header += fmt::format("property {} {}\n", column.type == SurfelColumn::Type::integer ? "int" : "double",
                          column.title);
  sink(header + "end_header\n");
  for (const auto& vertex : mesh.vertices) sink(fmt::format("{}\n", fmt::join(vertex, " ")));

  fmt::memory_buffer face;
  for (std::size_t i = 0; i < table.rows; ++i) {
    face.clear();
    fmt::format_to(std::back_inserter(face), "4 {}", fmt::join(mesh.quads[i], " "));
    for (const SurfelColumn& column : table.values)
      fmt::format_to(std::back_inserter(face), " {}", column.value(i));
    face.push_back('\n');
    sink({face.data(), face.size()});
  }
}

}  // namespace gridstep
