#include "estimators/integral_invariant/radial/radial_weights.hpp"

#include <algorithm>
#include <cmath>

namespace gridstep {

RadialWeight::RadialWeight(const RadialKernel& kernel, DigitalLength radius)
    : kernel_(kernel), squared_diameter_(4 * radius.value * radius.value) {
  double greatest = 0;
  for (int i = 0; i <= 1024; ++i) greatest = std::max(greatest, std::abs(kernel(i / 1024.0)));
  unit_ = greatest * 0x1p-20;
}

std::int64_t RadialWeight::operator()(std::int64_t squared) const {
  const double t = std::min(1.0, double(squared) / squared_diameter_);
  return std::llround(kernel_(t) / unit_);
}

}  // namespace gridstep
