#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/core/json_reader.hpp"
#include "experiments/detail_study.hpp"
#include "experiments/study.hpp"
#include "shapes/base/contracts.hpp"

// A study is read, with all that it names, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const nlohmann::json json = gridstep::parse_json(text, "fuzz");
    if (gridstep::DetailStudy::is(json))
      gridstep::DetailStudy::read(json, "fuzz");
    else
      gridstep::Study::read(json, "fuzz");
  } catch (const gridstep::InputError&) {
  }
  return 0;
}
