#include "estimators/integral_invariant/bricks/targets.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>

#include "estimators/integral_invariant/bricks/cut_plain.hpp"
#include "estimators/integral_invariant/bricks/simd_targets.hpp"

namespace gridstep::bricks {

namespace {

const Target& find_target(const std::string& name) {
  std::vector<std::string> known;
  for (const Target& one : targets()) {
    if (one.name == name) return one;
    known.push_back(one.name);
  }
  throw InputError(
      fmt::format("GRIDSTEP_TARGET is '{}'; this processor runs: {}", name, fmt::join(known, ", ")));
}

const Target*& chosen() {
  static const Target* const at_start = [] {
    const char* const name = std::getenv("GRIDSTEP_TARGET");
    return name ? &find_target(name) : &targets().front();
  }();
  static const Target* now = at_start;
  return now;
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = [] {
    std::vector<Target> result = simd_targets();
    result.push_back({"plain", cut_plain<2, Counts<2>>, cut_plain<2, Moments<2>>, cut_plain<3, Counts<3>>,
                      cut_plain<3, Moments<3>>});
    return result;
  }();
  return all;
}

const Target& target() {
  return *chosen();
}

void use_target(const std::string& name) {
  chosen() = &find_target(name);
}

}  // namespace gridstep::bricks
