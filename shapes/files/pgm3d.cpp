#include <fmt/format.h>

#include <algorithm>

#include "shapes/files/formats.hpp"
#include "shapes/files/pnm.hpp"

namespace gridstep {

GreyVolume read_pgm3d(ByteReader& file) {
  static constexpr PnmMagic magics[] = {{"P2", PnmEncoding::decimals},
                                        {"P2-3D", PnmEncoding::decimals},
                                        {"P3D", PnmEncoding::bytes},
                                        {"P5", PnmEncoding::bytes},
                                        {"P5-3D", PnmEncoding::bytes}};
  static constexpr std::string_view sides[] = {"width", "height", "depth"};
  const PnmGrid grid = read_pnm(file, magics, sides, "PGM volume (P2, P2-3D, P3D, P5 or P5-3D)");
  const VoxelType type = grid.maximum > 255 ? VoxelType::uint16 : VoxelType::uint8;
  GreyVolume volume = volume_of_size(file, {grid.sides[0], grid.sides[1], grid.sides[2]}, type);
  if (type == VoxelType::uint8)
    volume.bytes.assign(grid.values.begin(), grid.values.end());
  else
    volume.bytes.assign(reinterpret_cast<const char*>(grid.values.data()), 2 * grid.values.size());
  return volume;
}

void write_pgm3d(const GreyVolume& volume, const Sink& sink) {
  const VoxelType type = volume.type == VoxelType::uint8 ? VoxelType::uint8 : VoxelType::uint16;
  GreyVolume values = as_type(volume, type);
  put_in_order(values.bytes, bytes_of(type), std::endian::big);
  sink(fmt::format("P5-3D\n{} {} {}\n{}\n", volume.extent[0], volume.extent[1], volume.extent[2],
                   type == VoxelType::uint8 ? 255 : 65535));
  sink(values.bytes);
}

}  // namespace gridstep
