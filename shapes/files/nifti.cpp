#include <fmt/format.h>
#include <nifti2_io.h>

#include <cmath>

#include "shapes/files/formats.hpp"
#include "shapes/files/inflate.hpp"

namespace gridstep {

namespace {

/// The bytes of a file, or of the gzip stream that it is.
class Content {
 public:
  explicit Content(ByteReader& file) : file_(file) {
    if (file.rest().starts_with("\x1f\x8b")) stream_.emplace(file);
  }
  std::size_t most() const { return stream_ ? stream_->most() : file_.left(); }
  std::string take(std::size_t size, const char* what) {
    if (size > most()) file_.fail(fmt::format("truncated: ends before its {}", what));
    return stream_ ? stream_->take(size) : std::string(file_.take(size));
  }
  void expect_end() {
    if (stream_) stream_->expect_end();
  }

 private:
  ByteReader& file_;
  std::optional<Inflater> stream_;
};

VoxelType type_of(const ByteReader& file, int code) {
  switch (code) {
    case DT_UINT8:
      return VoxelType::uint8;
    case DT_INT8:
      return VoxelType::int8;
    case DT_UINT16:
      return VoxelType::uint16;
    case DT_INT16:
      return VoxelType::int16;
    case DT_UINT32:
      return VoxelType::uint32;
    case DT_INT32:
      return VoxelType::int32;
    case DT_UINT64:
      return VoxelType::uint64;
    case DT_INT64:
      return VoxelType::int64;
    case DT_FLOAT32:
      return VoxelType::float32;
    case DT_FLOAT64:
      return VoxelType::float64;
    default:
      file.fail(fmt::format("datatype = {} ({}): must be one of integers, float32 or float64", code,
                            nifti_datatype_string(code)));
  }
}

/// slope value + intercept, as doubles.
GreyVolume scaled(GreyVolume volume, double slope, double intercept) {
  GreyVolume result = std::move(volume);
  const std::string before = std::move(result.bytes);
  result.bytes.assign(result.voxels() * sizeof(double), '\0');
  with_type(result.type, [&]<class T>(T) {
    for (std::size_t i = 0, n = result.voxels(); i < n; ++i) {
      T value;
      std::memcpy(&value, before.data() + i * sizeof value, sizeof value);
      const double after = slope * double(value) + intercept;
      std::memcpy(result.bytes.data() + i * sizeof after, &after, sizeof after);
    }
  });
  result.type = VoxelType::float64;
  return result;
}

}  // namespace

GreyVolume read_nifti(ByteReader& file) {
  Content content(file);
  const std::string bytes = content.take(sizeof(nifti_1_header), "NIfTI-1 header");
  nifti_1_header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  // The format's mark of the other byte order.
  const bool swapped = header.dim[0] < 1 || header.dim[0] > 7;
  if (swapped) swap_nifti_header(&header, 1);
  const std::endian other =
      std::endian::native == std::endian::little ? std::endian::big : std::endian::little;
  const std::endian order = swapped ? other : std::endian::native;

  if (header.sizeof_hdr != sizeof header || std::string_view(header.magic, 4) != std::string_view("n+1\0", 4))
    file.fail("not a NIfTI-1 volume in one file");
  const int dimension = header.dim[0];
  if (dimension < 1 || dimension > 7) file.fail(fmt::format("dim[0] = {}: must be in [1, 7]", dimension));
  std::array<std::int64_t, 3> sides{1, 1, 1};
  for (int i = 1; i <= dimension; ++i) {
    if (i <= 3)
      sides[std::size_t(i - 1)] = header.dim[i];
    else if (header.dim[i] != 1)
      file.fail(fmt::format("dim[{}] = {}: must be 1, for a volume of dimension 3", i, header.dim[i]));
  }
  GreyVolume volume = volume_of_size(file, sides, type_of(file, header.datatype));
  std::array<double, 3> spacings;
  for (int i = 1; i <= 3; ++i)
    spacings[std::size_t(i - 1)] = i <= dimension ? header.pixdim[i] : header.pixdim[1];
  volume.spacing = isotropic_spacing(file, "pixdim", spacings);

  const double offset = header.vox_offset;
  if (!(offset >= sizeof header && offset == std::trunc(offset)))
    file.fail(fmt::format("vox_offset = {}: must be an integer of at least {}", offset, sizeof header));
  if (offset - sizeof header > double(content.most())) file.fail("truncated: ends before its voxels");
  content.take(std::size_t(offset) - sizeof header, "voxels");  // extensions
  volume.bytes = content.take(needed_bytes(file, volume, content.most()), "voxels");
  content.expect_end();
  put_in_order(volume.bytes, bytes_of(volume.type), order);

  const double slope = header.scl_slope, intercept = header.scl_inter;
  if (!std::isfinite(slope) || !std::isfinite(intercept))
    file.fail(fmt::format("scl_slope = {}, scl_inter = {}: must be finite", slope, intercept));
  const bool scales = slope != 0 && (slope != 1 || intercept != 0);  // 0: not to be scaled
  return scales ? scaled(std::move(volume), slope, intercept) : volume;
}

}  // namespace gridstep
