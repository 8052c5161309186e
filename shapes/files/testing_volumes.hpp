#pragma once

#include <zlib.h>

#include <array>
#include <cstring>
#include <string>

#include "shapes/files/formats.hpp"

// Small files for the tests of readers, and what is said of bad ones.
namespace gridstep {

/// What an action fails with; empty where it does not.
template <class Action>
std::string failure(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// What such a file is refused with, after its name; empty where it is read.
template <class Read>
std::string refusal(Read read, const std::string& content) {
  ByteReader file("small", content);
  try {
    read(file);
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (!message.starts_with("small: ")) return "no name in: " + message;
    if (message.find('\n') != std::string::npos) return "more than one line: " + message;
    return message.substr(7);
  }
  return "";
}

template <class Read>
GreyVolume volume_in(Read read, const std::string& content) {
  ByteReader file("small", content);
  return read(file);
}

/// How many bytes to add to the window bits, as zlib wants it: a zlib stream, or a gzip file.
enum class Deflate { zlib = 0, gzip = 16 };

inline std::string deflated(const std::string& bytes, Deflate format = Deflate::zlib) {
  z_stream z{};
  deflateInit2(&z, 9, Z_DEFLATED, MAX_WBITS + int(format), 9, Z_DEFAULT_STRATEGY);
  std::string result(deflateBound(&z, bytes.size()) + 32, '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = uInt(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(result.data());
  z.avail_out = uInt(result.size());
  deflate(&z, Z_FINISH);
  result.resize(z.total_out);
  deflateEnd(&z);
  return result;
}

/// The 24 voxels of a volume of 2 x 3 x 4: 0, 1, 2, ...
inline const std::string kVoxels = [] {
  std::string bytes;
  for (char i = 0; i < 24; ++i) bytes += i;
  return bytes;
}();

/// The bytes of a number, as this processor has them.
template <class T>
std::string bytes_in(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// A NIfTI-1 header in this processor's order, of 2 x 3 x 4 voxels of uint8, with four bytes up to the voxels.
class NiftiFile {
 public:
  NiftiFile() {
    set<std::int32_t>(0, 348).dim({3, 2, 3, 4, 1, 1, 1, 1}).set<std::int16_t>(70, 2).set<std::int16_t>(72, 8);
    for (int i = 0; i < 8; ++i) set<float>(76 + 4 * std::size_t(i), 1);
    set<float>(108, 352);
    header_.replace(344, 4, "n+1\0", 4);
  }
  /// By the offset that the format's definition gives.
  template <class T>
  NiftiFile& set(std::size_t offset, T value) {
    header_.replace(offset, sizeof value, bytes_in(value));
    return *this;
  }
  NiftiFile& dim(const std::array<std::int16_t, 8>& sizes) {
    for (std::size_t i = 0; i < 8; ++i) set(40 + 2 * i, sizes[i]);
    return *this;
  }
  std::string with(const std::string& voxels) const { return header_ + voxels; }

 private:
  std::string header_ = std::string(352, '\0');
};

}  // namespace gridstep
