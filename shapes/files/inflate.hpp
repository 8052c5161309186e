#pragma once

#include <memory>
#include <string>

#include "shapes/files/byte_reader.hpp"

namespace gridstep {

/// What a zlib stream or the members of a gzip file hold, from front to back, told apart by their headers.
class Inflater {
 public:
  /// The stream is all that is left of the file, which has to stay where it is.
  explicit Inflater(ByteReader& file);
  ~Inflater();

  /// No stream of this length expands to more.
  std::size_t most() const;
  /// The next `size` bytes. Memory grows with what is there, not with what is asked for.
  /// @throws InputError where the stream is corrupt or ends before.
  std::string take(std::size_t size);
  /// @throws InputError where there is more, or the checksum is wrong.
  void expect_end();

 private:
  struct Stream;
  std::size_t read(char* to, std::size_t size);

  ByteReader& file_;
  std::unique_ptr<Stream> stream_;
};

}  // namespace gridstep
