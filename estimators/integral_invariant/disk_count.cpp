#include "estimators/integral_invariant/disk_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "shapes/digital/boundary.hpp"

namespace gridstep {

DiskRows::DiskRows(DigitalLength radius) {
  const double r = radius.value;
  if (!(r >= 1 && r <= 0x1p14))
    throw InputError(fmt::format("kernel radius R/h = {:.6g}: must be from 1 to {} cells", r, 1 << 14));
  const auto limit = std::int64_t(std::floor(r * r * (1 + 1e-12)));  // as in ball_kernel()
  std::int64_t x = std::int64_t(std::ceil(r)) + 1;
  for (std::int64_t y = 0; y * y <= limit; ++y) {
    while (x * x + y * y > limit) --x;
    half_width_.push_back(int(x));
  }
}

RowRuns::RowRuns(const DigitalSet<2>& set) {
  // A run begins at a linel whose inner point is on its right, and ends at one whose inner point is on its left.
  std::vector<LatticePoint<2>> firsts, lasts;
  for (const Surfel<2>& linel : boundary(set))
    if (linel.axis == 0) (linel.sign < 0 ? firsts : lasts).push_back(linel.inner);
  if (firsts.empty()) return;
  std::sort(firsts.begin(), firsts.end(), raster_less<2>);
  std::sort(lasts.begin(), lasts.end(), raster_less<2>);
  lowest_row_ = firsts.front()[1];
  row_begin_.assign(std::size_t(firsts.back()[1] - lowest_row_) + 2, 0);
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    const bool same_row = i > 0 && firsts[i][1] == firsts[i - 1][1];
    const std::int64_t before =
        same_row ? runs_.back().before + runs_.back().last - runs_.back().first + 1 : 0;
    runs_.push_back({firsts[i][0], lasts[i][0], before});
    ++row_begin_[std::size_t(firsts[i][1] - lowest_row_) + 1];
  }
  for (std::size_t row = 1; row < row_begin_.size(); ++row) row_begin_[row] += row_begin_[row - 1];
}

std::pair<RowRuns::Runs::const_iterator, RowRuns::Runs::const_iterator> RowRuns::runs_of(int y) const {
  const std::int64_t row = std::int64_t{y} - lowest_row_;
  if (row < 0 || row + 1 >= std::int64_t(row_begin_.size())) return {runs_.end(), runs_.end()};
  return {runs_.begin() + std::ptrdiff_t(row_begin_[std::size_t(row)]),
          runs_.begin() + std::ptrdiff_t(row_begin_[std::size_t(row) + 1])};
}

std::int64_t RowRuns::count_up_to(int y, int x) const {
  const auto [begin, end] = runs_of(y);
  const auto after =
      std::upper_bound(begin, end, x, [](int value, const Run& run) { return value < run.first; });
  if (after == begin) return 0;
  const Run& run = *std::prev(after);
  return run.before + std::min(x, run.last) - run.first + 1;
}

std::int64_t RowRuns::count(int y, int first, int last) const {
  return count_up_to(y, last) - count_up_to(y, first - 1);
}

std::int64_t RowRuns::count(const LatticePoint<2>& centre, const DiskRows& disk) const {
  std::int64_t result = 0;
  for (int y = -disk.reach(); y <= disk.reach(); ++y)
    result += count(centre[1] + y, centre[0] - disk.half_width(y), centre[0] + disk.half_width(y));
  return result;
}

}  // namespace gridstep
