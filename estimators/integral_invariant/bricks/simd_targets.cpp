// Compiled once for each instruction set, by Highway (https://github.com/google/highway).

#include "estimators/integral_invariant/bricks/simd_targets.hpp"

#include <algorithm>
#include <cctype>

#include "estimators/integral_invariant/bricks/cut_plain.hpp"
#include "estimators/integral_invariant/bricks/simd_settings.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "estimators/integral_invariant/bricks/simd_targets.cpp"
#include <hwy/foreach_target.h>
//
#include "estimators/integral_invariant/bricks/simd_counts.ipp"
#include "estimators/integral_invariant/bricks/simd_moments.ipp"

// What Highway falls back to where there are no vectors; simd_targets() leaves it out.
#if HWY_TARGET == HWY_SCALAR
namespace gridstep::bricks::HWY_NAMESPACE {
namespace {
Counts<2> count_2d(const SourceLists<2, Counts<2>>& lists, const AlignedBall<2>& ball) {
  return cut_plain(lists, ball);
}
Counts<3> count_3d(const SourceLists<3, Counts<3>>& lists, const AlignedBall<3>& ball) {
  return cut_plain(lists, ball);
}
Moments moments_3d(const SourceLists<3, Moments>& lists, const AlignedBall<3>& ball) {
  return cut_plain(lists, ball);
}
}  // namespace
}  // namespace gridstep::bricks::HWY_NAMESPACE
#endif

#if HWY_ONCE
namespace gridstep::bricks {

HWY_EXPORT(count_2d);
HWY_EXPORT(count_3d);
HWY_EXPORT(moments_3d);

std::vector<Target> simd_targets() {
  std::vector<Target> result;
  for (const std::int64_t one : hwy::SupportedAndGeneratedTargets()) {
    if (one & (HWY_SCALAR | HWY_EMU128)) continue;
    hwy::GetChosenTarget().Update(one);
    std::string name = hwy::TargetName(one);
    if (name == "AVX3_DL") name = "avx512-dl";
    if (name == "AVX3") name = "avx512";
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    result.push_back({name, &HWY_DYNAMIC_DISPATCH(count_2d), &HWY_DYNAMIC_DISPATCH(count_3d),
                      &HWY_DYNAMIC_DISPATCH(moments_3d)});
  }
  hwy::GetChosenTarget().DeInit();
  return result;
}

}  // namespace gridstep::bricks
#endif
