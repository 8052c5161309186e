#include "experiments/program/surfel_output.hpp"

#include <optional>

namespace gridstep {

bool is_standard_output(const std::string& path) {
  return path == "-" || path == "/dev/stdout";
}

SurfelOutput::SurfelOutput(const std::string& csv, const std::vector<std::string>& paths, int d) {
  to_standard_output_ = is_standard_output(csv);
  // First, since it may be a pipe or a device, where commit() may still fail: then nothing else is left.
  if (!csv.empty()) files_.push_back({&surface_format(".csv", d), csv == "-" ? "/dev/stdout" : csv, nullptr});
  for (const std::string& path : paths) files_.push_back({&surface_format(path, d), path, nullptr});
  for (File& f : files_) f.file = std::make_unique<OutputFile>(f.path);
}

template <int d>
void SurfelOutput::write(const SurfelTable& table, std::span<const Surfel<d>> surfels, GridStep h) {
  [[maybe_unused]] std::optional<QuadMesh> mesh;
  for (const auto& [format, path, file] : files_) {
    const Sink sink = [&out = *file](std::string_view bytes) { out.write(bytes); };
    if (format->write_table) {
      format->write_table(table, sink);
    } else if constexpr (d == 3) {
      if (!mesh) mesh = quad_mesh(surfels, h);
      format->write_mesh(table, *mesh, sink);
    }
  }
  for (const File& file : files_) file.file->commit();
}

template void SurfelOutput::write(const SurfelTable&, std::span<const Surfel<2>>, GridStep);
template void SurfelOutput::write(const SurfelTable&, std::span<const Surfel<3>>, GridStep);

}  // namespace gridstep
