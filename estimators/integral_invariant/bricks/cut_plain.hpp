#pragma once

#include <span>

#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// CutSums in words of 64 bits, on any processor.
template <int d, class Sum>
void cut_plain(const SourceLists<d, Sum>& lists, const BallRows<d>& ball, std::span<const std::uint16_t> bits,
               Sum* sums);

}  // namespace gridstep::bricks
