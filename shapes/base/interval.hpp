#pragma once

#include <boost/numeric/interval.hpp>

namespace gridstep {

/// Interval arithmetic in round-to-nearest. Since +, -, * and sqrt are monotone under rounding, the interval
/// value of an expression contains every value that the same expression, evaluated in the same order, takes
/// in doubles on the interval's points: it bounds the sign of the *computed* expression, not of the exact
/// one. This holds for expressions without division by an interval and without contraction into fused
/// operations.
using Interval = boost::numeric::interval<
    double, boost::numeric::interval_lib::policies<boost::numeric::interval_lib::rounded_arith_exact<double>,
                                                   boost::numeric::interval_lib::checking_base<double>>>;

/// x * x, with the tight bound for intervals.
inline double square(double x) {
  return x * x;
}
inline Interval square(const Interval& x) {
  return boost::numeric::square(x);
}

/// x times a number, for scalars that know no shorter way than a product of two.
template <class Scalar>
Scalar scaled(const Scalar& x, double factor) {
  return x * Scalar(factor);
}

/// x^n by repeated multiplication, in the same order for doubles and for intervals; n >= 0.
template <class Scalar>
Scalar integer_power(const Scalar& x, int n) {
  if (n == 0) return Scalar(1.0);
  if (n == 1) return x;
  const Scalar half = integer_power(x, n / 2);
  return n % 2 == 0 ? square(half) : square(half) * x;
}

}  // namespace gridstep
