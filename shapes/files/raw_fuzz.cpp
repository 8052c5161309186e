#include "shapes/files/formats.hpp"
#include "shapes/files/testing_fuzz.hpp"

// The layout comes from the first bytes, as a user may give any.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t before = 3 * sizeof(std::int64_t) + 2;
  if (size < before) return 0;
  gridstep::RawLayout layout;
  std::memcpy(layout.sides.data(), data, 3 * sizeof(std::int64_t));
  layout.type = gridstep::kVoxelTypes[data[before - 2] % gridstep::kVoxelTypes.size()];
  layout.order = data[before - 1] % 2 == 0 ? std::endian::little : std::endian::big;
  gridstep::read_or_refuse([&](gridstep::ByteReader& file) { return read_raw(file, layout); }, data + before,
                           size - before);
  return 0;
}
