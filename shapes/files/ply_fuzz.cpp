#include <cstdlib>

#include "shapes/base/contracts.hpp"
#include "shapes/files/surface_file.hpp"

// A file is read, with a value of each title at each face, or refused in one line; so are its surfels.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gridstep::ByteReader file("fuzz", std::string(reinterpret_cast<const char*>(data), size));
  try {
    const gridstep::PlySurface surface = gridstep::read_ply(file);
    if (surface.columns.size() != surface.titles.size()) std::abort();
    for (const auto& column : surface.columns)
      if (column.size() != surface.mesh.quads.size()) std::abort();
    gridstep::surfels_of(surface.mesh, {0.5});
  } catch (const gridstep::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
