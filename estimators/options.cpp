#include "estimators/options.hpp"

#include <fmt/format.h>

#include "shapes/base/contracts.hpp"

namespace gridstep {

Evaluation parse_evaluation(const std::string& name) {
  if (name == "full") return Evaluation::full;
  if (name == "masks") return Evaluation::masks;
  throw InputError(fmt::format("unknown evaluation '{}'; known: full, masks", name));
}

std::string to_string(Evaluation evaluation) {
  return evaluation == Evaluation::full ? "full" : "masks";
}

KernelCentre parse_kernel_centre(const std::string& name) {
  if (name == "spels") return KernelCentre::spels;
  if (name == "surfel") return KernelCentre::surfel;
  throw InputError(fmt::format("unknown kernel centre '{}'; known: spels, surfel", name));
}

}  // namespace gridstep
