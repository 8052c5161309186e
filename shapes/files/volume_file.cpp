#include "shapes/files/volume_file.hpp"

#include "shapes/files/extension.hpp"

namespace gridstep {

namespace {

/// A format whose files say themselves what they hold.
template <GreyVolume read(ByteReader&)>
GreyVolume self_described(ByteReader& file, const std::optional<RawLayout>& layout) {
  if (layout) file.fail("says its sizes itself; --size and --type are for .raw");
  return read(file);
}

GreyVolume described(ByteReader& file, const std::optional<RawLayout>& layout) {
  if (!layout) file.fail("does not say its sizes; --size X,Y,Z does (and --type)");
  return read_raw(file, *layout);
}

}  // namespace

const std::vector<VolumeFormat>& volume_formats() {
  static const std::vector<VolumeFormat> formats{{".vol", self_described<read_vol>, write_vol},
                                                 {".longvol", self_described<read_longvol>, write_longvol},
                                                 {".pgm3d", self_described<read_pgm3d>, write_pgm3d},
                                                 {".raw", described, write_raw},
                                                 {".nrrd", self_described<read_nrrd>, write_nrrd},
                                                 {".nii", self_described<read_nifti>, nullptr},
                                                 {".nii.gz", self_described<read_nifti>, nullptr},
                                                 {".vti", nullptr, write_vti}};
  return formats;
}

const VolumeFormat& readable_volume_format(const std::string& path) {
  return format_of(path, volume_formats(), [](const VolumeFormat& format) { return format.read != nullptr; });
}

const VolumeFormat& writable_volume_format(const std::string& path) {
  return format_of(path, volume_formats(),
                   [](const VolumeFormat& format) { return format.write != nullptr; });
}

GreyVolume read_volume(const std::string& path, const std::optional<RawLayout>& layout) {
  const VolumeFormat& format = readable_volume_format(path);
  ByteReader file = open_file(path);
  return format.read(file, layout);
}

std::pair<VoxelType, std::endian> parse_voxel_type(const std::string& text) {
  constexpr std::string_view big = "-be";
  const bool is_big = text.ends_with(big);
  const std::string_view name = std::string_view(text).substr(0, text.size() - (is_big ? big.size() : 0));
  std::string known;
  for (const VoxelType type : kVoxelTypes) {
    if (name == name_of(type)) return {type, is_big ? std::endian::big : std::endian::little};
    known += (known.empty() ? "" : ", ") + std::string(name_of(type));
  }
  throw InputError(fmt::format("unknown type '{}'; known: {}, with -be for big endian", text, known));
}

}  // namespace gridstep
