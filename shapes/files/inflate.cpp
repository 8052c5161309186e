#include "shapes/files/inflate.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

constexpr std::size_t kLongestCall = std::size_t(1) << 30;  // zlib counts in unsigned ints
constexpr std::size_t kFirstChunk = std::size_t(1) << 16;
constexpr std::size_t kLargestRatio = 1032;  // of deflate: 258 bytes from two bits

}  // namespace

struct Inflater::Stream {
  z_stream z{};
  std::string_view input;  // that zlib has not been given yet
  bool ended = false;
};

Inflater::Inflater(ByteReader& file) : file_(file), stream_(std::make_unique<Stream>()) {
  if (inflateInit2(&stream_->z, 32 + MAX_WBITS) != Z_OK) throw std::bad_alloc();
  stream_->input = file.take(file.left());
}

Inflater::~Inflater() {
  inflateEnd(&stream_->z);
}

std::size_t Inflater::most() const {
  const std::size_t compressed = stream_->input.size() + stream_->z.avail_in;
  constexpr std::size_t held = 64;  // more than zlib has read and not yet expanded
  return (compressed + held) * kLargestRatio;
}

std::size_t Inflater::read(char* to, std::size_t size) {
  z_stream& z = stream_->z;
  std::string_view& input = stream_->input;
  std::size_t got = 0;
  while (got < size && !stream_->ended) {
    if (z.avail_in == 0) {
      const std::size_t next = std::min(input.size(), kLongestCall);
      z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(input.data()));
      z.avail_in = uInt(next);
      input.remove_prefix(next);
    }
    const std::size_t wanted = std::min(size - got, kLongestCall);
    z.next_out = reinterpret_cast<Bytef*>(to + got);
    z.avail_out = uInt(wanted);
    const int status = inflate(&z, Z_NO_FLUSH);
    got += wanted - z.avail_out;
    if (status == Z_STREAM_END) {
      // A gzip file may have several members; of anything else that follows, it is not known what it is.
      const bool another = z.avail_in >= 2 && z.next_in[0] == 0x1f && z.next_in[1] == 0x8b;
      stream_->ended = !another;
      if (another) inflateReset(&z);
    } else if (status == Z_MEM_ERROR) {
      throw std::bad_alloc();
    } else if (status != Z_OK && status != Z_BUF_ERROR) {
      file_.fail(fmt::format("corrupt zlib stream: {}", z.msg ? z.msg : "a dictionary is missing"));
    } else if (z.avail_in == 0 && input.empty() && z.avail_out > 0) {
      file_.fail("truncated: ends within its zlib stream");
    }
  }
  return got;
}

std::string Inflater::take(std::size_t size) {
  std::string bytes;
  while (bytes.size() < size) {
    const std::size_t before = bytes.size(), next = std::min(size, std::max(2 * before, kFirstChunk));
    bytes.resize(next);
    const std::size_t got = read(bytes.data() + before, next - before);
    if (got < next - before)
      file_.fail(fmt::format("truncated: its zlib stream holds {} of {} bytes", before + got, size));
  }
  return bytes;
}

void Inflater::expect_end() {
  char more;
  if (read(&more, 1) > 0) file_.fail("its zlib stream holds more than the voxels");
}

}  // namespace gridstep
