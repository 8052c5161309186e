#pragma once

#include <vector>

#include "estimators/integral_invariant/bricks/targets.hpp"

namespace gridstep::bricks {

/// The inner loops in vector instructions, for each instruction set that was compiled and that this processor
/// has, the widest first: avx512-dl (which counts bits in one instruction), avx512 and avx2 on x86. Maybe none.
std::vector<Target> simd_targets();

}  // namespace gridstep::bricks
