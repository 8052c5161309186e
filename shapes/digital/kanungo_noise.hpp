#pragma once

#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// Kanungo noise [Kanungo et al., IEEE PAMI 22(11), 2000], geometric form: every point changes sides with
/// probability beta^(1 + distance), independently.
///
/// distance = city-block steps to the nearest point of the other side, less one: 0 for the points that a
/// surfel touches. Points where the probability is below 1e-9 are left alone. The outcome depends on the seed
/// and the point alone, not on any order. beta in [0, 1); beta = 0 leaves the set as it is.
template <int d>
DigitalSet<d> kanungo_noise(const DigitalSet<d>& set, double beta, std::uint64_t seed);

}  // namespace gridstep
