#include <fmt/format.h>

#include "shapes/files/formats.hpp"
#include "shapes/files/vtk_xml.hpp"

namespace gridstep {

void write_vti(const GreyVolume& volume, const Sink& sink) {
  const LatticePoint<3> last = volume.extent.array() - 1;
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", last[0], last[1], last[2]);
  VtkXml file("ImageData");
  file.open(fmt::format("ImageData WholeExtent=\"{}\" Origin=\"0 0 0\" Spacing=\"{} {} {}\"", extent,
                        volume.spacing, volume.spacing, volume.spacing));
  file.open(fmt::format("Piece Extent=\"{}\"", extent));
  file.open("PointData Scalars=\"value\"");
  file.array("value", vtk_name(volume.type), 1, volume.bytes);
  file.close("PointData");
  file.close("Piece");
  file.close("ImageData");
  file.write(sink);
}

}  // namespace gridstep
