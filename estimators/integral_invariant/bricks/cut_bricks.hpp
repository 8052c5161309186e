#pragma once

#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// The parts that the ball around one spel cuts out of the bricks of M and the runs of F; plain 64-bit words.
/// bit: the spel's, in the source brick. Positions are taken from the spel.
template <int d, class Sum>
Sum cut_sum(const SourceLists<d, Sum>& lists, const BallRows<d>& ball, int bit);

}  // namespace gridstep::bricks
