#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapes/files/formats.hpp"

namespace gridstep {

/// A line of the table of formats.
struct VolumeFormat {
  std::string_view extension;
  GreyVolume (*read)(ByteReader& file, const std::optional<RawLayout>& layout);  ///< null: only written
  void (*write)(const GreyVolume& volume, const Sink& sink);                     ///< null: only read
};

const std::vector<VolumeFormat>& volume_formats();

/// By the extension of a path. @throws InputError listing the extensions that can be read.
const VolumeFormat& readable_volume_format(const std::string& path);
/// The same for writing.
const VolumeFormat& writable_volume_format(const std::string& path);

/// @param layout of a .raw file, which needs it; no other takes one
/// @throws InputError naming the file and what is wrong with it.
GreyVolume read_volume(const std::string& path, const std::optional<RawLayout>& layout = std::nullopt);

/// "uint8", "int16", ..., with "-be" behind it for big endian. @throws InputError listing the types.
std::pair<VoxelType, std::endian> parse_voxel_type(const std::string& text);

}  // namespace gridstep
