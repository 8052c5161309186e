#include "shapes/files/formats.hpp"
#include "shapes/files/testing_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gridstep::read_or_refuse(gridstep::read_vol, data, size);
  return 0;
}
