#pragma once

#include <cstddef>
#include <vector>

#include "experiments/record.hpp"
#include "experiments/study.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

/// One digitization of a sweep: a shape, a noise, a level of the schedule and a shift.
struct Job {
  const Sweep* sweep;
  std::size_t shape, noise, level;
  int shift;

  GridStep h() const { return {sweep->schedule.values()[level]}; }
};

/// How many surfels a job holds at a time, where it may take the boundary in parts. Of each surfel it keeps the errors,
/// 8 bytes a quantity and method, and of those at hand up to 600 bytes more.
inline constexpr std::size_t kSurfelsInPart = std::size_t{1} << 20;

/// The records of all methods of the sweep, in their order. Each record's errors come from all surfels, whatever the
/// parts; its work does so but for spels on two parts, which are evaluated twice, and for restarts.
/// @throws std::runtime_error where two evaluations differ in one of their sums.
template <int d>
std::vector<Record> run_job(const Study& study, const Job& job, const Shape<d>& shape,
                            std::size_t surfels_in_part = kSurfelsInPart);

}  // namespace gridstep
