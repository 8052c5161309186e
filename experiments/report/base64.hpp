#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace gridstep {

/// Bytes as text [RFC 4648], padded.
std::string base64(std::span<const std::byte> bytes);

/// Of the values as they lie in memory; browsers and all processors built for here are little-endian.
template <class T>
std::string base64(const std::vector<T>& values) {
  return base64(std::as_bytes(std::span(values)));
}

}  // namespace gridstep
