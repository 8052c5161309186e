#include "experiments/program/volume_options.hpp"

#include <fmt/format.h>

#include "shapes/files/volume_file.hpp"

namespace gridstep {

void add_raw_layout_options(CLI::App& command, VolumeOptions& options) {
  auto* size = command.add_option("--size", options.size, "Of a .raw volume: X,Y,Z voxels")
                   ->delimiter(',')
                   ->expected(1, 3);
  command
      .add_option(
          "--type", options.type,
          "Of a .raw volume: uint8 (default), int8, uint16, int16, uint32, int32, uint64, int64, float32 or "
          "float64; with -be behind it for big endian")
      ->needs(size);
}

GreyVolume read_volume(const VolumeOptions& options) {
  if (options.size.empty()) return read_volume(options.path);
  if (options.size.size() != 3)
    throw InputError(fmt::format("--size = {}: must be X,Y,Z", fmt::join(options.size, ",")));
  const auto [type, order] = parse_voxel_type(options.type);
  return read_volume(options.path,
                     RawLayout{{options.size[0], options.size[1], options.size[2]}, type, order});
}

GreyRange grey_range(const std::vector<double>& threshold) {
  if (threshold.size() != 2 || !(threshold[0] <= threshold[1]))
    throw InputError(
        fmt::format("--threshold = {}: must be LOW,HIGH with LOW <= HIGH", fmt::join(threshold, ",")));
  return {threshold[0], threshold[1]};
}

}  // namespace gridstep
