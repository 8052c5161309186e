#include "shapes/files/vtk_xml.hpp"

#include <fmt/format.h>

namespace gridstep {

std::string_view vtk_name(VoxelType type) {
  constexpr std::string_view names[] = {"UInt8", "Int8",   "UInt16", "Int16",   "UInt32",
                                        "Int32", "UInt64", "Int64",  "Float32", "Float64"};
  return names[std::size_t(type)];
}

VtkXml::VtkXml(std::string_view type)
    : text_(fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"{}\" "
                        "header_type=\"UInt64\">\n",
                        type, std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian")) {}

void VtkXml::open(std::string_view element_with_attributes) {
  text_ += fmt::format("<{}>\n", element_with_attributes);
}

void VtkXml::close(std::string_view element) {
  text_ += fmt::format("</{}>\n", element);
}

void VtkXml::array(std::string_view name, std::string_view type, int components, std::string_view bytes) {
  text_ += fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
      "offset=\"{}\"/>\n",
      type, name, components, offset_);
  arrays_.push_back(bytes);
  offset_ += sizeof(std::uint64_t) + bytes.size();
}

void VtkXml::write(const Sink& sink) const {
  sink(text_ + "<AppendedData encoding=\"raw\">\n_");
  for (const std::string_view bytes : arrays_) {
    const std::uint64_t size = bytes.size();
    sink({reinterpret_cast<const char*>(&size), sizeof size});
    sink(bytes);
  }
  sink("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace gridstep
