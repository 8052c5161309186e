#pragma once

#include <string>
#include <vector>

#include "estimators/integral_invariant/bricks/source_lists.hpp"

namespace gridstep::bricks {

/// The inner loops, compiled for one kind of processor: cut_sum(lists, ball) is the part of the ball's sum that
/// lies in the bricks of M and the runs of F, positions taken from the spel.
struct Target {
  std::string name;
  Counts<2> (*count_2d)(const SourceLists<2, Counts<2>>& lists, const AlignedBall<2>& ball);
  Counts<3> (*count_3d)(const SourceLists<3, Counts<3>>& lists, const AlignedBall<3>& ball);
  Moments (*moments_3d)(const SourceLists<3, Moments>& lists, const AlignedBall<3>& ball);

  Counts<2> cut_sum(const SourceLists<2, Counts<2>>& lists, const AlignedBall<2>& ball) const {
    return count_2d(lists, ball);
  }
  Counts<3> cut_sum(const SourceLists<3, Counts<3>>& lists, const AlignedBall<3>& ball) const {
    return count_3d(lists, ball);
  }
  Moments cut_sum(const SourceLists<3, Moments>& lists, const AlignedBall<3>& ball) const {
    return moments_3d(lists, ball);
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
