// Compiled once for each instruction set, by Highway (https://github.com/google/highway).

#include "estimators/integral_invariant/bricks/simd_targets.hpp"

// On other processors, and below AVX2, there is `plain`: Highway then compiles nothing but its own fallback.
#define GRIDSTEP_SIMD_TARGETS (HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL)
#define HWY_DISABLED_TARGETS (~(GRIDSTEP_SIMD_TARGETS | HWY_SCALAR | HWY_EMU128))
// AVX-512 of the processors that also count bits, which is not among Highway's defaults.
#define HWY_WANT_AVX3_DL 1

#define HWY_TARGET_INCLUDE "estimators/integral_invariant/bricks/simd_targets.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#if HWY_TARGET & GRIDSTEP_SIMD_TARGETS
#include "estimators/integral_invariant/bricks/simd_vectors.ipp"
//
#include "estimators/integral_invariant/bricks/simd_line_runs.ipp"
//
#include "estimators/integral_invariant/bricks/simd_counts.ipp"
#include "estimators/integral_invariant/bricks/simd_moments_2d.ipp"
#include "estimators/integral_invariant/bricks/simd_moments_3d.ipp"
#endif

#if HWY_ONCE
namespace gridstep::bricks {

std::vector<Target> simd_targets() {
  std::vector<Target> result;
  [[maybe_unused]] const auto supported = hwy::SupportedTargets();
#if HWY_TARGETS & HWY_AVX3_DL
  if (supported & HWY_AVX3_DL)
    result.push_back({"avx512-dl", N_AVX3_DL::count_2d, N_AVX3_DL::moments_2d, N_AVX3_DL::count_3d,
                      N_AVX3_DL::moments_3d});
#endif
#if HWY_TARGETS & HWY_AVX3
  if (supported & HWY_AVX3)
    result.push_back({"avx512", N_AVX3::count_2d, N_AVX3::moments_2d, N_AVX3::count_3d, N_AVX3::moments_3d});
#endif
#if HWY_TARGETS & HWY_AVX2
  if (supported & HWY_AVX2)
    result.push_back({"avx2", N_AVX2::count_2d, N_AVX2::moments_2d, N_AVX2::count_3d, N_AVX2::moments_3d});
#endif
  return result;
}

}  // namespace gridstep::bricks
#endif
