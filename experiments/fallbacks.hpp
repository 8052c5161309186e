#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "experiments/core/table.hpp"
#include "experiments/record.hpp"

namespace gridstep {

/// Where the guard of an estimator chose another kernel than the first, so that its errors are not those of the kernel
/// that it is named after.
struct Fallbacks : Setting {
  struct Count {
    std::int64_t fallbacks = 0, surfels = 0;  ///< summed up over the shifts
  };
  std::map<double, Count, std::greater<>> by_step;  ///< at h, from coarse to fine, also where there are none
};

/// One entry for each setting with a fallback anywhere, in the order of the records. At each step, records of the first
/// evaluation alone: guards decide on the same sums in all.
std::vector<Fallbacks> fallbacks_of(const std::vector<Record>& records);

/// One row an entry.
Table fallback_table(const std::vector<Fallbacks>& fallbacks);

}  // namespace gridstep
