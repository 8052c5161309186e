#include <fmt/format.h>

#include "shapes/files/surface_file.hpp"

namespace gridstep {

void write_ply(const SurfelTable& table, const QuadMesh& mesh, const Sink& sink) {
  std::string header = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\n",
      std::endian::native == std::endian::little ? "little" : "big", mesh.vertices.size(), mesh.quads.size());
  for (const SurfelColumn& column : table.values)
    header += fmt::format("property {} {}\n", column.type == SurfelColumn::Type::integer ? "int" : "double",
                          column.title);
  sink(header + "end_header\n");
  sink({reinterpret_cast<const char*>(mesh.vertices.data()), mesh.vertices.size() * sizeof mesh.vertices[0]});

  std::string face;
  const auto append = [&face]<class T>(const T& value) {
    face.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (std::size_t i = 0; i < table.rows; ++i) {
    face.assign(1, char(4));
    append(mesh.quads[i]);
    for (const SurfelColumn& column : table.values) {
      const double value = column.value(i);
      if (column.type == SurfelColumn::Type::integer)
        append(std::int32_t(value));
      else
        append(value);
    }
    sink(face);
  }
}

}  // namespace gridstep
