#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shapes/files/grey_volume.hpp"

namespace gridstep {

/// VTK's name of a type: UInt8, Float64, ...
std::string_view vtk_name(VoxelType type);

/// Puts together a file of VTK's XML formats, its arrays appended as they are in memory.
class VtkXml {
 public:
  explicit VtkXml(std::string_view type);

  void open(std::string_view element_with_attributes);
  void close(std::string_view element);
  /// `bytes` has to live until write().
  void array(std::string_view name, std::string_view type, int components, std::string_view bytes);
  void write(const Sink& sink) const;

 private:
  std::string text_;
  std::vector<std::string_view> arrays_;
  std::uint64_t offset_ = 0;
};

}  // namespace gridstep
