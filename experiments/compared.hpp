#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimators/catalogue.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

/// A quantity of an estimator as it is compared with the truth: a scalar by its difference (estimate minus
/// truth), a tangent or normal by its angle with the true one, in radians. Principal directions are not
/// compared: where the curvatures are equal there are none.
struct Compared {
  std::string name;                  ///< kappa, mean, ...; tangent, normal
  std::vector<std::string> columns;  ///< of the estimates and of the truth
  std::optional<double> proven_rate;
};

template <int d>
std::vector<Compared> compared_quantities(const EstimatorEntry::Variant<d>& variant);

/// The same by the name of an estimator; none where there is no such one in that dimension.
std::vector<Compared> compared_quantities(const std::string& estimator, int dimension);

/// The error at each value; 0 where truth.known is 0. @throws ContractViolation where a column is missing.
/// Runs on all threads of the current arena.
std::vector<double> errors_of(const Compared& compared, const Estimates& estimates, const Truth& truth);

/// Only those where the truth is known, in order.
std::vector<double> known_only(std::vector<double> errors, const Truth& truth);

}  // namespace gridstep
