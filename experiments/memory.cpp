#include "experiments/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

/// What can still be allocated without swapping.
double available_memory() {
  std::ifstream file("/proc/meminfo");
  std::string key, unit;
  for (double kib; file >> key >> kib; std::getline(file, unit))
    if (key == "MemAvailable:") return kib * 1024;
  return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
}

}  // namespace

template <int d>
double predicted_surfels(const RealBox<d>& bounds, GridStep h) {
  const RealPoint<d> cells = bounds.sizes() / h.value;
  double surfels = 0;
  for (int axis = 0; axis < d; ++axis) surfels += 2 * cells.prod() / cells[axis];
  return surfels;
}

template <int d>
double predicted_set_memory(const RealBox<d>& bounds, GridStep h) {
  const double bricks_for_each_surfel = 64.0 * (d == 2 ? 1.0 / 16 : 1.0 / 40);
  const double book_cells = d == 2 ? 0x1p29 : 0x1p24;
  const RealPoint<d> cells = bounds.sizes() / h.value;
  return predicted_surfels<d>(bounds, h) * bricks_for_each_surfel + 4 * cells.prod() / book_cells;
}

double predicted_surfel_memory(bool moments) {
  return moments ? 440 : 180;
}

template <int d>
double predicted_table_memory(const EstimatorEntry::Variant<d>& variant, DigitalLength radius,
                              Evaluation evaluation, int threads) {
  const double r = radius.value, pi = std::numbers::pi;
  if (evaluation == Evaluation::bricks && variant.table_memory) return variant.table_memory(radius);
  const bool moments = d == 3 && variant.quantities.size() > 1;
  // Half-widths for each line of the ball and two prefix sums of them, for each line of a source brick; from R/h of some
  // 350 on most rows of bricks are split.
  if (evaluation == Evaluation::bricks)
    return (d == 2 ? 200 * r : (moments ? 3.3 : 1.2) * std::max(300.0, r) * r * r) + 0x1p17;
  const double kernel = (d == 2 ? pi * r * r : 4 * pi / 3 * r * r * r) * 16;
  const double masks = evaluation == Evaluation::full ? 0 : (d == 2 ? 8 * 5 * r : 231 * r * r) * 16;
  const double dense_kernel = evaluation == Evaluation::full ? 0 : 8 * std::pow(2 * r + 5, d);
  const double window = std::pow(std::max(2 * r + (d == 2 ? 256 : 32), 3 * r), d);
  return kernel + masks + dense_kernel + threads * window;
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * double(usage.ru_maxrss);
}

std::string memory_report(double predicted, std::int64_t surfels) {
  const double peak = peak_memory(), gib = 0x1p30;
  return fmt::format("peak memory {:.3g} GiB ({:.3g} bytes a surfel), predicted {:.3g} GiB", peak / gib,
                     peak / double(surfels), predicted / gib);
}

void require_memory(double bytes, const std::string& what) {
  const double available = available_memory(), gib = 0x1p30;
  if (bytes > 0.9 * available)
    throw InputError(fmt::format("{}: needs about {:.3g} GiB of memory, but only {:.3g} GiB are available",
                                 what, bytes / gib, available / gib));
}

#define GRIDSTEP_INSTANTIATE(d)                                                                           \
  template double predicted_surfels<d>(const RealBox<d>&, GridStep);                                      \
  template double predicted_set_memory<d>(const RealBox<d>&, GridStep);                                   \
  template double predicted_table_memory<d>(const EstimatorEntry::Variant<d>&, DigitalLength, Evaluation, \
                                            int);
GRIDSTEP_INSTANTIATE(2)
GRIDSTEP_INSTANTIATE(3)
#undef GRIDSTEP_INSTANTIATE

}  // namespace gridstep
