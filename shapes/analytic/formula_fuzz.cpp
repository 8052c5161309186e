#include "shapes/analytic/formula.hpp"

#include <array>
#include <cstdlib>

#include "shapes/base/contracts.hpp"

// A formula is parsed, and evaluated, or refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const gridstep::Formula formula(std::string(reinterpret_cast<const char*>(data), size));
    const std::array point{0.5, -2.0, 3.0};
    formula(std::span<const double>(point));
    formula.magnitude(point);
  } catch (const gridstep::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
