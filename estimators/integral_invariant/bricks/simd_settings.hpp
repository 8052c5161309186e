#pragma once

// Below AVX2 there is little to gain over words of 64 bits.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
// AVX-512 of the processors that also count bits.
#define HWY_WANT_AVX3_DL 1
