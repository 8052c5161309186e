#include "shapes/files/formats.hpp"
#include "shapes/files/libvol.hpp"

namespace gridstep {

GreyVolume read_vol(ByteReader& file) {
  return read_libvol(file, VoxelType::uint8);
}

void write_vol(const GreyVolume& volume, const Sink& sink) {
  write_libvol(volume, VoxelType::uint8, "Voxel", sink);
}

}  // namespace gridstep
