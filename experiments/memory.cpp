#include "experiments/memory.hpp"

#include <fmt/format.h>
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
double predicted_memory(const RealBox<d>& bounds, GridStep h, DigitalLength radius, bool moments,
                        Evaluation evaluation, int threads) {
  const double r = radius.value, pi = std::numbers::pi;
  const RealPoint<d> cells = bounds.sizes() / h.value;
  double surfels = 0;
  for (int axis = 0; axis < d; ++axis) surfels += 2 * cells.prod() / cells[axis];

  // A surfel, its spels and their sums, its columns of estimates and of truth.
  const double for_each_surfel = moments ? 600 : 200;
  const double bricks_for_each_surfel = 64.0 * (d == 2 ? 1.0 / 16 : 1.0 / 40);
  const double page_cells = d == 2 ? 0x1p19 : 0x1p15;
  const double index = 4 * cells.prod() / page_cells;

  const double set = surfels * (for_each_surfel + bricks_for_each_surfel) + index;
  // Half-widths for each line of the ball and their prefix sums, for all alignments.
  if (evaluation == Evaluation::bricks)
    return set + (d == 2 ? 1200 * r : (moments ? 3000 : 500) * r * r) + 0x1p16;
  const double kernel = (d == 2 ? pi * r * r : 4 * pi / 3 * r * r * r) * 16;
  const double masks = evaluation == Evaluation::full ? 0 : (d == 2 ? 8 * 5 * r : 231 * r * r) * 16;
  const double dense_kernel = evaluation == Evaluation::full ? 0 : 8 * std::pow(2 * r + 5, d);
  const double window = std::pow(std::max(2 * r + (d == 2 ? 256 : 32), 3 * r), d);
  return set + kernel + masks + dense_kernel + threads * window;
}

void require_memory(double bytes, const std::string& what) {
  const double available = available_memory(), gib = 0x1p30;
  if (bytes > 0.9 * available)
    throw InputError(fmt::format("{}: needs about {:.3g} GiB of memory, but only {:.3g} GiB are available",
                                 what, bytes / gib, available / gib));
}

template double predicted_memory<2>(const RealBox<2>&, GridStep, DigitalLength, bool, Evaluation, int);
template double predicted_memory<3>(const RealBox<3>&, GridStep, DigitalLength, bool, Evaluation, int);

}  // namespace gridstep
