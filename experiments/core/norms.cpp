#include "experiments/core/norms.hpp"

#include <algorithm>
#include <cmath>

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

/// Neumaier's variant of Kahan's summation [ZAMM 54, 1974] for terms >= 0.
class CompensatedSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += sum_ >= term ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

}  // namespace

ErrorNorms error_norms(std::span<const double> errors) {
  expects(!errors.empty(), "at least one error to take a norm of");
  double sup = 0;
  bool finite = true;
  for (const double e : errors) {
    finite = finite && std::isfinite(e);
    sup = std::max(sup, std::abs(e));
  }
  expects(finite, "finite errors");
  if (sup == 0) return {0, 0, 0, errors.size()};

  // Relative to sup, squares neither overflow nor vanish.
  CompensatedSum absolute, squares;
  for (const double e : errors) {
    const double relative = std::abs(e) / sup;
    absolute.add(relative);
    squares.add(relative * relative);
  }
  const double count = double(errors.size());
  return {sup, sup * std::sqrt(squares.value() / count), sup * (absolute.value() / count), errors.size()};
}

}  // namespace gridstep
