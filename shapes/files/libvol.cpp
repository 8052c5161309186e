#include "shapes/files/libvol.hpp"

#include <fmt/format.h>

#include <map>

namespace gridstep {

namespace {

class Header {
 public:
  explicit Header(ByteReader& file) : file_(file) {
    for (int number = 1;; ++number) {
      const auto line = file.line();
      if (!line) file.fail("truncated: ends within its header");
      if (*line == ".") return;
      const std::size_t colon = line->find(':');
      if (colon == 0 || colon == std::string_view::npos)
        file.fail(fmt::format("header line {}: '{}' is no 'Key: value'", number, shown(*line)));
      const std::string key(line->substr(0, colon));
      if (!fields_.emplace(key, trimmed(line->substr(colon + 1))).second)
        file.fail(fmt::format("header line {}: {} is given twice", number, shown(key)));
    }
  }

  std::optional<std::string_view> text(const std::string& key) const {
    const auto field = fields_.find(key);
    return field == fields_.end() ? std::nullopt : std::optional<std::string_view>(field->second);
  }
  std::optional<std::int64_t> integer(const std::string& key) const {
    const auto value = text(key);
    if (!value) return std::nullopt;
    const auto number = number_in<std::int64_t>(*value);
    if (!number) file_.fail(fmt::format("{} = {}: must be an integer", key, shown(*value)));
    return number;
  }
  std::int64_t needed_integer(const std::string& key) const {
    const auto number = integer(key);
    if (!number) file_.fail(fmt::format("its header has no {}", key));
    return *number;
  }
  std::endian order() const {
    const std::string_view digits = text("Int-Endian").value_or("0123");
    if (digits == "0123") return std::endian::little;
    if (digits == "3210") return std::endian::big;
    file_.fail(fmt::format("Int-Endian = {}: must be 0123 (little) or 3210 (big)", shown(digits)));
  }

 private:
  ByteReader& file_;
  std::map<std::string, std::string> fields_;
};

/// Of the oldest files: the sides once more, and a line end.
void skip_raw_header(ByteReader& file, const GreyVolume& volume, std::endian order) {
  constexpr std::size_t size = 3 * sizeof(std::int32_t) + 1;
  if (file.left() < size) file.fail("truncated: ends within the sizes before its voxels");
  std::string sides(file.take(size));
  if (sides.back() != '\n') file.fail("no version in its header, and no line end between sizes and voxels");
  sides.pop_back();
  put_in_order(sides, sizeof(std::int32_t), order);
  for (int axis = 0; axis < 3; ++axis) {
    std::int32_t side;
    std::memcpy(&side, sides.data() + std::size_t(axis) * sizeof side, sizeof side);
    if (side != volume.extent[axis])
      file.fail(fmt::format("{} = {} in its header, but {} before its voxels", "XYZ"[axis],
                            volume.extent[axis], side));
  }
}

}  // namespace

GreyVolume read_libvol(ByteReader& file, VoxelType type) {
  const Header header(file);
  GreyVolume volume = volume_of_size(
      file, {header.needed_integer("X"), header.needed_integer("Y"), header.needed_integer("Z")}, type);
  // Not so Lvoxel-Size: programs write 4 there before voxels of 8 bytes.
  if (const auto size = header.integer("Voxel-Size"); size && *size != std::int64_t(bytes_of(type)))
    file.fail(fmt::format("Voxel-Size = {}: must be {}", *size, bytes_of(type)));
  const std::endian order = header.order();
  const auto version = header.integer("Version");
  if (version && *version != 2 && *version != 3)
    file.fail(fmt::format("Version = {}: must be 2 or 3", *version));
  if (!version) skip_raw_header(file, volume, order);
  if (version == 3)
    read_deflated_voxels(file, volume, order);
  else
    read_raw_voxels(file, volume, order);
  return volume;
}

void write_libvol(const GreyVolume& volume, VoxelType type, std::string_view prefix, const Sink& sink) {
  GreyVolume voxels = as_type(volume, type);
  put_in_order(voxels.bytes, bytes_of(type), std::endian::little);
  const LatticePoint<3>& n = volume.extent;
  // With these centres, programs that follow them have the first voxel at 0.
  sink(fmt::format(
      "Center-X: {}\nCenter-Y: {}\nCenter-Z: {}\nX: {}\nY: {}\nZ: {}\n{}-Size: {}\nAlpha-Color: 0\n"
      "{}-Endian: 0\nInt-Endian: 0123\nVersion: 2\n.\n",
      (n[0] - 1) / 2, (n[1] - 1) / 2, (n[2] - 1) / 2, n[0], n[1], n[2], prefix, bytes_of(type), prefix));
  sink(voxels.bytes);
}

}  // namespace gridstep
