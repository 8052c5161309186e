#include <fmt/format.h>

#include <deque>

#include "shapes/files/surface_file.hpp"
#include "shapes/files/vtk_xml.hpp"

namespace gridstep {

namespace {

template <class T>
std::string_view bytes_in(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// How many columns from `first` on make one array, and its name: three where they are one vector's.
std::pair<std::size_t, std::string> array_at(const std::vector<SurfelColumn>& columns, std::size_t first) {
  const std::string& title = columns[first].title;
  if (first + 2 < columns.size() && title.ends_with("_x")) {
    const std::string stem = title.substr(0, title.size() - 2);
    if (columns[first + 1].title == stem + "_y" && columns[first + 2].title == stem + "_z") return {3, stem};
  }
  return {1, title};
}

}  // namespace

void write_vtp(const SurfelTable& table, const QuadMesh& mesh, const Sink& sink) {
  std::vector<std::int64_t> connectivity, offsets;
  for (const auto& quad : mesh.quads) {
    connectivity.insert(connectivity.end(), quad.begin(), quad.end());
    offsets.push_back(std::int64_t(connectivity.size()));
  }
  std::deque<std::vector<double>> arrays;  // which stay where they are

  VtkXml file("PolyData");
  file.open("PolyData");
  file.open(
      fmt::format("Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
                  "NumberOfPolys=\"{}\"",
                  mesh.vertices.size(), mesh.quads.size()));
  file.open("CellData");
  for (std::size_t c = 0; c < table.values.size();) {
    const auto [components, name] = array_at(table.values, c);
    std::vector<double>& values = arrays.emplace_back();
    values.reserve(components * table.rows);
    for (std::size_t i = 0; i < table.rows; ++i)
      for (std::size_t k = 0; k < components; ++k) values.push_back(table.values[c + k].value(i));
    file.array(name, "Float64", int(components), bytes_in(values));
    c += components;
  }
  file.close("CellData");
  file.open("Points");
  file.array("Points", "Float64", 3, bytes_in(mesh.vertices));
  file.close("Points");
  file.open("Polys");
  file.array("connectivity", "Int64", 1, bytes_in(connectivity));
  file.array("offsets", "Int64", 1, bytes_in(offsets));
  file.close("Polys");
  file.close("Piece");
  file.close("PolyData");
  file.write(sink);
}

}  // namespace gridstep
