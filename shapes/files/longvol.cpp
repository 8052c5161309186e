#include "shapes/files/formats.hpp"
#include "shapes/files/libvol.hpp"

namespace gridstep {

GreyVolume read_longvol(ByteReader& file) {
  return read_libvol(file, VoxelType::uint64);
}

void write_longvol(const GreyVolume& volume, const Sink& sink) {
  write_libvol(volume, VoxelType::uint64, "Lvoxel", sink);
}

}  // namespace gridstep
