#include "estimators/integral_invariant/kernel.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gridstep {

std::int64_t squared_diameter(DigitalLength radius) {
  const double r = radius.value;
  if (!(r >= 1 && std::isfinite(r)))
    throw InputError(fmt::format("kernel radius R/h = {:.6g}: must be at least 1 cell", r));
  if (r > 1e9) throw InputError(fmt::format("kernel radius R/h = {:.6g}: too large", r));
  return std::int64_t(std::floor(4 * r * r * (1 + 1e-12)));
}

template <int d>
Kernel<d, std::int64_t> ball_kernel(DigitalLength radius, int half_axis) {
  const double r = radius.value;
  const std::int64_t limit = squared_diameter(radius);
  // Also keeps the conversion to int below defined.
  if (std::pow(2 * r + 5, d) >= 0x1p31)
    throw InputError(
        fmt::format("kernel radius R/h = {:.6g}: too large, its box would hold more than 2^31 cells", r));
  const int reach = int(std::ceil(r)) + 1;

  // In half cells, so that the centre of a surfel has integer coordinates too.
  Kernel<d, std::int64_t> kernel;
  for_each_point(LatticeBox<d>{LatticePoint<d>::Constant(-reach), LatticePoint<d>::Constant(reach)},
                 [&](const LatticePoint<d>& z) {
                   std::int64_t squared = 0;
                   for (int k = 0; k < d; ++k) {
                     const std::int64_t x = 2 * std::int64_t{z[k]} - (k == half_axis);
                     squared += x * x;
                   }
                   if (squared <= limit) kernel.offsets.push_back(z);
                 });
  kernel.groups = {{1, 0, kernel.size()}};
  return kernel;
}

template Kernel<2, std::int64_t> ball_kernel<2>(DigitalLength, int);
template Kernel<3, std::int64_t> ball_kernel<3>(DigitalLength, int);

}  // namespace gridstep
