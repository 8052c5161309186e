#include "shapes/files/image_file.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gridstep::ByteReader file("fuzz", std::string(reinterpret_cast<const char*>(data), size));
  try {
    const gridstep::GreyImage image = gridstep::read_image(file);
    if (image.values.size() != std::size_t(image.width) * std::size_t(image.height)) std::abort();
    threshold(image, 1, 100);
  } catch (const gridstep::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
