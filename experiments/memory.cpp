#include "experiments/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "shapes/base/contracts.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"
#include "shapes/digital/kanungo_noise.hpp"

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
SetSize size_of(const DigitalSet<d>& set) {
  return {double(boundary_size(set)), double(set.memory())};
}

template <int d>
SetSize predicted_size(const std::string& name, const Shape<d>& shape, const SceneSettings<d>& settings) try {
  constexpr double kEnough = d == 2 ? 1e4 : 1e5;  // surfels
  constexpr int kMostHalvings = 6;                // of the step, where the shape is far smaller than its box
  const GridStep h = settings.h;
  const RealPoint<d> sizes = shape.bounds().sizes();
  double area = 0;
  for (int axis = 0; axis < d; ++axis) area += 2 * sizes.prod() / sizes[axis];
  GridStep coarse{std::max(h.value, std::pow(area / kEnough, 1.0 / (d - 1)))};
  for (int halvings = 0;; ++halvings) {
    DigitalSet<d> set = gauss_digitize<d>(shape, coarse);
    if (settings.noise > 0) set = kanungo_noise(set, settings.noise, settings.noise_seed);
    const SetSize size = size_of(set);
    if (size.surfels >= kEnough / 2 || coarse.value <= h.value || halvings == kMostHalvings) {
      const double growth = std::pow(coarse.value / h.value, d - 1);
      const double books = (sizes / h.value).prod() / (d == 2 ? 0x1p29 : 0x1p24);
      return {growth * size.surfels, growth * size.bytes + 4 * books};
    }
    coarse.value = std::max(h.value, coarse.value / 2);
  }
} catch (const InputError& error) {
  throw InputError(fmt::format("{}: {}", name, error.what()));
}

double predicted_surfel_memory(bool moments) {
  return moments ? 440 : 140;
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
  template SetSize predicted_size<d>(const std::string&, const Shape<d>&, const SceneSettings<d>&);       \
  template SetSize size_of<d>(const DigitalSet<d>&);                                                      \
  template double predicted_table_memory<d>(const EstimatorEntry::Variant<d>&, DigitalLength, Evaluation, \
                                            int);
GRIDSTEP_INSTANTIATE(2)
GRIDSTEP_INSTANTIATE(3)
#undef GRIDSTEP_INSTANTIATE

}  // namespace gridstep
