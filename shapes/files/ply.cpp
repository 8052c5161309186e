#include <fmt/format.h>

#include <iterator>

#include "shapes/base/contracts.hpp"
#include "shapes/files/surface_file.hpp"

namespace gridstep {

namespace {

class PlyReader {
 public:
  explicit PlyReader(ByteReader& file) : file_(file) {}

  PlySurface read() {
    expect("ply");
    expect("format ascii 1.0");
    const std::size_t vertices = count("element vertex ");
    for (const char* coordinate : {"x", "y", "z"}) expect(fmt::format("property double {}", coordinate));
    const std::size_t faces = count("element face ");
    expect("property list uchar int vertex_indices");
    PlySurface surface;
    for (std::string_view text = line(); text != "end_header"; text = line())
      surface.titles.push_back(title(text));

    // A line has a digit and a space or line end for each number: a header may claim anything.
    require_left(vertices, 3);
    surface.mesh.vertices.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      std::string_view text = line();
      auto& vertex = surface.mesh.vertices.emplace_back();
      for (double& coordinate : vertex) coordinate = number<double>(text);
      finish(text);
    }
    require_left(faces, 5 + surface.titles.size());
    surface.mesh.quads.reserve(faces);
    surface.columns.resize(surface.titles.size());
    for (auto& column : surface.columns) column.reserve(faces);
    for (std::size_t i = 0; i < faces; ++i) read_face(surface);
    if (file_.left() > 0) fail("more than its header says");
    return surface;
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    file_.fail(fmt::format("line {}: {}", number_of_line_, what));
  }

  std::string_view line() {
    ++number_of_line_;
    const auto text = file_.line();
    if (!text) fail("truncated");
    return *text;
  }

  void expect(std::string_view wanted) {
    if (const std::string_view text = line(); text != wanted)
      fail(fmt::format("'{}' where '{}' is expected", shown(text), wanted));
  }

  std::size_t count(std::string_view before) {
    const std::string_view text = line();
    const auto value =
        text.starts_with(before) ? number_in<std::int32_t>(text.substr(before.size())) : std::nullopt;
    if (!value || *value < 0) fail(fmt::format("'{}' where '{}COUNT' is expected", shown(text), before));
    return std::size_t(*value);
  }

  std::string title(std::string_view text) {
    const std::string_view property = next_word(text), type = next_word(text), name = next_word(text);
    if (property != "property" || (type != "double" && type != "int") || name.empty())
      fail("no property of a face that is a number");
    finish(text);
    return std::string(name);
  }

  void require_left(std::size_t lines, std::size_t numbers) const {
    if (lines > file_.left() / (2 * numbers)) file_.fail("truncated: its header says more");
  }

  template <class Number>
  Number number(std::string_view& text) {
    const std::string_view word = next_word(text);
    const auto value = number_in<Number>(word);
    if (!value) fail(fmt::format("'{}' is no number that may stand here", shown(word)));
    return *value;
  }

  void finish(std::string_view text) const {
    if (!trimmed(text).empty()) fail("more than its header says");
  }

  void read_face(PlySurface& surface) {
    std::string_view text = line();
    if (number<int>(text) != 4) fail("not a square");
    auto& quad = surface.mesh.quads.emplace_back();
    for (std::int32_t& vertex : quad) {
      vertex = number<std::int32_t>(text);
      if (vertex < 0 || std::size_t(vertex) >= surface.mesh.vertices.size())
        fail(fmt::format("there is no vertex {}", vertex));
    }
    for (auto& column : surface.columns) column.push_back(number<double>(text));
    finish(text);
  }

  ByteReader& file_;
  std::size_t number_of_line_ = 0;
};

}  // namespace

PlySurface read_ply(ByteReader& file) {
  return PlyReader(file).read();
}

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
