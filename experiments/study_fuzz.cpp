#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/core/json_reader.hpp"
#include "experiments/study.hpp"
#include "shapes/base/contracts.hpp"

// A study is read, with all that it names, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    gridstep::Study::read(gridstep::parse_json(text, "fuzz"), "fuzz");
  } catch (const gridstep::InputError&) {
  }
  return 0;
}
