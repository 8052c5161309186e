#include "shapes/files/surface_file.hpp"

#include "shapes/files/extension.hpp"

namespace gridstep {

const std::vector<SurfaceFormat>& surface_formats() {
  static const std::vector<SurfaceFormat> formats{{".csv", write_csv, nullptr},
                                                  {".npy", write_npy, nullptr},
                                                  {".ply", nullptr, write_ply},
                                                  {".vtp", nullptr, write_vtp},
                                                  {".obj", nullptr, write_obj}};
  return formats;
}

const SurfaceFormat& surface_format(const std::string& path, int d) {
  return format_of(path, surface_formats(),
                   [d](const SurfaceFormat& format) { return d == 3 || format.write_mesh == nullptr; });
}

}  // namespace gridstep
