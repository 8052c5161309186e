#include "estimators/integral_invariant/disk_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

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

std::int64_t count_in_disk(const DigitalSet<2>& set, const LatticePoint<2>& centre, const DiskRows& disk) {
  constexpr int kWidth = Brick<2>::extent(0), kHeight = Brick<2>::extent(1);
  const LatticePoint<2> corner = LatticePoint<2>::Constant(disk.reach());
  const LatticePoint<2> lowest = Brick<2>::of(centre - corner), highest = Brick<2>::of(centre + corner);
  std::int64_t count = 0;
  for_each_point(LatticeBox<2>{lowest, highest}, [&](const LatticePoint<2>& b) {
    const std::int32_t state = set.state(b);
    if (state == DigitalSet<2>::kEmpty) return;
    const LatticePoint<2> origin = Brick<2>::origin(b) - centre;
    const int first_row = std::max(0, -disk.reach() - origin[1]);
    const int last_row = std::min(kHeight - 1, disk.reach() - origin[1]);
    const Brick<2> bits = state == DigitalSet<2>::kFull ? Brick<2>::full() : set.brick(b);
    for (int row = first_row; row <= last_row; ++row) {
      const int w = disk.half_width(origin[1] + row);
      const int first = std::max(0, -w - origin[0]), last = std::min(kWidth - 1, w - origin[0]);
      if (first > last) continue;
      const std::uint64_t mask = (~std::uint64_t{0} >> (kWidth - 1 - (last - first))) << first;
      count += std::popcount(bits.words[std::size_t(row)] & mask);
    }
  });
  return count;
}

}  // namespace gridstep
