#pragma once

#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// The inner loops, compiled for one kind of processor: the sums over E for the balls around the spels `bits` of a
/// source brick, in increasing order; positions taken from the brick.
template <int d, class Sum>
using CutSums = void (*)(const SourceLists<d, Sum>& lists, const BallRows<d>& ball,
                         std::span<const std::uint16_t> bits, Sum* sums);

struct Target {
  std::string name;
  CutSums<2, Counts<2>> count_2d;
  CutSums<2, Moments<2>> moments_2d;
  CutSums<3, Counts<3>> count_3d;
  CutSums<3, Moments<3>> moments_3d;

  template <int d, class Sum>
  CutSums<d, Sum> cut_sums() const {
    if constexpr (std::is_same_v<Sum, Counts<2>>)
      return count_2d;
    else if constexpr (std::is_same_v<Sum, Moments<2>>)
      return moments_2d;
    else if constexpr (std::is_same_v<Sum, Counts<3>>)
      return count_3d;
    else
      return moments_3d;
  }
};

/// Those that this processor can run, the best one first; the last one is `plain`, 64-bit words and no more.
const std::vector<Target>& targets();

/// The best one, unless the environment variable GRIDSTEP_TARGET names another when the first evaluation starts.
/// @throws InputError where it names none of targets().
const Target& target();

/// For tests: takes the place of the environment variable. Not while an evaluation runs.
/// @throws InputError as target().
void use_target(const std::string& name);

}  // namespace gridstep::bricks
