#pragma once

#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// The part of a ball that lies in the bricks of M and the runs of F, positions taken from its spel: in words of 64
/// bits, on any processor.
template <int d, class Sum>
Sum cut_plain(const SourceLists<d, Sum>& lists, const AlignedBall<d>& ball);

}  // namespace gridstep::bricks
