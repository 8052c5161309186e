#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "shapes/files/grey_volume.hpp"

namespace gridstep {

/// What has to hold whatever a file is: it is read, with all the voxels it claims, or refused in one line. A crash
/// is what the fuzzer looks for.
template <class Read>
void read_or_refuse(Read read, const std::uint8_t* data, std::size_t size) {
  ByteReader file("fuzz", std::string(reinterpret_cast<const char*>(data), size));
  try {
    const GreyVolume volume = read(file);
    if (volume.bytes.size() != volume.voxels() * bytes_of(volume.type)) std::abort();
    threshold(volume, {1, 100});
  } catch (const InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
}

}  // namespace gridstep
