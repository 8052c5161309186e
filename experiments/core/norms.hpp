#pragma once

#include <cstddef>
#include <span>

namespace gridstep {

/// Stored with every record, so that a number can never be taken for another norm.
inline constexpr const char* norm_definition =
    "sup = max|e|, rms = sqrt(mean(e^2)), mean = mean|e|, over surfels";

struct ErrorNorms {
  double sup, rms, mean;
  std::size_t count;
};

/// The norms of the errors e at the `count` surfels of one digitization, each in the unit of e:
///   sup = max|e|,  rms = sqrt(mean(e^2)),  mean = mean|e|.
/// Each is a mean or a maximum, so the norm of a constant error does not depend on the count; sqrt(sum)/n
/// would fall with h by itself and feign convergence. Sums are compensated: the rounding error does not grow
/// with the count.
/// @throws ContractViolation if there is no error, or one that is not finite.
ErrorNorms error_norms(std::span<const double> errors);

}  // namespace gridstep
