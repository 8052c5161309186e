#include <fmt/format.h>

#include "shapes/files/formats.hpp"

namespace gridstep {

GreyVolume read_raw(ByteReader& file, const RawLayout& layout) {
  GreyVolume volume = volume_of_size(file, layout.sides, layout.type);
  const std::size_t there = file.left();
  if (const std::size_t needed = needed_bytes(file, volume, there); needed < there)
    file.fail(fmt::format("its {} x {} x {} voxels of {} need {} bytes, but it has {}", volume.extent[0],
                          volume.extent[1], volume.extent[2], name_of(volume.type), needed, there));
  read_raw_voxels(file, volume, layout.order);
  return volume;
}

void write_raw(const GreyVolume& volume, const Sink& sink) {
  std::string bytes = volume.bytes;
  put_in_order(bytes, bytes_of(volume.type), std::endian::little);
  sink(bytes);
}

}  // namespace gridstep
