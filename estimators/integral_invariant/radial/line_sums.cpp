// Compiled once for each instruction set, by Highway (https://github.com/google/highway): AVX2, whose vectors are as long as
// a brick's lines, and what the compiler takes for granted.

#include "estimators/integral_invariant/radial/line_sums.hpp"

#include "estimators/integral_invariant/bricks/targets.hpp"

#define HWY_DISABLED_TARGETS (~(HWY_AVX2 | HWY_SCALAR | HWY_EMU128))
#define HWY_TARGET_INCLUDE "estimators/integral_invariant/radial/line_sums.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#define GRIDSTEP_INLINE HWY_INLINE
HWY_BEFORE_NAMESPACE();
namespace gridstep::HWY_NAMESPACE {
namespace {
#include "estimators/integral_invariant/radial/line_sums.ipp"
}  // namespace
AddBrick of_target() {
  return add_brick;
}
}  // namespace gridstep::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gridstep {

HWY_EXPORT(of_target);

AddBrick add_brick() {
  if (bricks::target().name == "plain") return HWY_STATIC_DISPATCH(of_target)();
  return HWY_DYNAMIC_DISPATCH(of_target)();
}

}  // namespace gridstep
#endif
