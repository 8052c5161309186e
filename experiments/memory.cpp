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

/// How many surfels a plane x = 0 is expected to have for each one, under kanungo_noise(): points in the k-th layer on
/// either side of it flip with probability p_k = beta^k, and neighbours of the same side get a surfel with p + q - 2 p q.
template <int d>
double growth_by_noise(double beta) {
  const double sum = beta / (1 - beta), sum_of_squares = beta * beta / (1 - beta * beta);
  const double within_layers = 2 * (d - 1) * (sum - sum_of_squares);
  const double between_layers = 2 * sum - beta - 2 * beta * sum_of_squares;
  return 1 - 2 * beta * (1 - beta) + 2 * (within_layers + between_layers);
}

}  // namespace

template <int d>
SetSize size_of(const DigitalSet<d>& set) {
  return {double(boundary_size(set)), double(set.memory())};
}

template <int d>
SetSize predicted_size(const std::string& name, const Shape<d>& shape, const SceneSettings<d>& settings) try {
  constexpr double kMostOfBox = d == 2 ? 1e4 : 1e5;  // surfels that the box would have, and half of them do
  constexpr double kMostBooks = 0x1p20;
  const GridStep h = settings.h;
  const RealPoint<d> cells = digital_bounds<d>(shape, h).extent().template cast<double>();
  const double books = cells.prod() / DigitalSet<d>::kBookPoints;
  double of_box = 0;
  for (int axis = 0; axis < d; ++axis) of_box += 2 * cells.prod() / cells[axis];

  double steps = std::max(1.0, std::pow(of_box / kMostOfBox, 1.0 / (d - 1)));  // the coarser step, in h
  SetSize size = size_of(gauss_digitize<d>(shape, {steps * h.value}));
  // Where the shape is far smaller than its box.
  while (size.surfels < kMostOfBox / 2 && steps > 1 && books / std::pow(steps / 2, d) < kMostBooks) {
    steps = std::max(1.0, steps / 2);
    size = size_of(gauss_digitize<d>(shape, {steps * h.value}));
  }
  const double growth = std::pow(steps, d - 1) * growth_by_noise<d>(settings.noise);
  const double surfels = size.surfels > 0 ? growth * size.surfels : of_box;
  return {surfels, growth * size.bytes + 4 * books};
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
