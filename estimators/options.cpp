#include "estimators/options.hpp"

#include <fmt/format.h>

#include "shapes/base/contracts.hpp"

namespace gridstep {

Evaluation parse_evaluation(const std::string& name) {
  for (const Evaluation evaluation : {Evaluation::full, Evaluation::masks, Evaluation::bricks})
    if (name == to_string(evaluation)) return evaluation;
  throw InputError(fmt::format("unknown evaluation '{}'; known: full, masks, bricks", name));
}

std::string to_string(Evaluation evaluation) {
  switch (evaluation) {
    case Evaluation::full:
      return "full";
    case Evaluation::masks:
      return "masks";
    case Evaluation::bricks:
      return "bricks";
  }
  throw ContractViolation("an evaluation without a name");
}

KernelCentre parse_kernel_centre(const std::string& name) {
  if (name == "spels") return KernelCentre::spels;
  if (name == "surfel") return KernelCentre::surfel;
  throw InputError(fmt::format("unknown kernel centre '{}'; known: spels, surfel", name));
}

}  // namespace gridstep
