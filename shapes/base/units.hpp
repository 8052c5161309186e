#pragma once

#include <cmath>

#include "shapes/base/contracts.hpp"

namespace gridstep {

/// Grid step h: the Euclidean length of the edge of a cell.
struct GridStep {
  double value;
};

/// A length in the unit of the shape.
struct EuclideanLength {
  double value;
};

/// A length in cells, not necessarily an integer.
struct DigitalLength {
  double value;
};

/// The only crossing between the two units of length.
inline DigitalLength to_digital(EuclideanLength length, GridStep h) {
  expects(h.value > 0, "grid step h > 0");
  return {length.value / h.value};
}

/// R(h) = k h^alpha; alpha = 1/3 balances the two error terms of integral invariants [Coeurjolly, Lachaud,
/// Levallois, CVIU 2014].
struct RadiusRule {
  double k;
  double alpha = 1.0 / 3.0;

  EuclideanLength at(GridStep h) const { return {k * std::pow(h.value, alpha)}; }
  friend bool operator==(const RadiusRule&, const RadiusRule&) = default;
};

}  // namespace gridstep
