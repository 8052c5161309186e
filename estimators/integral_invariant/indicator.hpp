#pragma once

#include <cstdint>
#include <cstring>
#include <span>

#include "estimators/integral_invariant/window.hpp"
#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// The shape functor of a digital set: 1 inside, 0 outside. Keeps a reference to the set.
template <int d>
class Indicator {
 public:
  using Value = std::uint8_t;

  explicit Indicator(const DigitalSet<d>& set) : set_(set) {}

  /// values[i] becomes f at the i-th point of the box in raster order.
  void fill(const LatticeBox<d>& box, std::span<Value> values) const {
    const WindowLayout<d> layout{box.extent()};
    for_each_point(LatticeBox<d>{Brick<d>::of(box.lo), Brick<d>::of(box.hi)}, [&](const LatticePoint<d>& b) {
      const std::int32_t state = set_.state(b);
      const Brick<d> brick = state < 0 ? Brick<d>{} : set_.brick(b);
      const LatticePoint<d> origin = Brick<d>::origin(b);
      LatticeBox<d> part{origin, origin};
      for (int k = 0; k < d; ++k) part.hi[k] += Brick<d>::extent(k) - 1;
      part = part.intersection(box);
      LatticeBox<d> row_starts = part;
      row_starts.hi[0] = part.lo[0];
      const std::size_t length = std::size_t(part.hi[0] - part.lo[0] + 1);
      for_each_point(row_starts, [&](const LatticePoint<d>& z) {
        Value* const row = values.data() + layout.distance(z - box.lo);
        if (state < 0) {
          std::memset(row, state == DigitalSet<d>::kFull, length);
          return;
        }
        const int bit = Brick<d>::bit(z);
        const std::uint64_t word = brick.words[std::size_t(bit) >> 6] >> (bit & 63);
        for (std::size_t i = 0; i < length; ++i) row[i] = (word >> i) & 1;
      });
    });
  }

 private:
  const DigitalSet<d>& set_;
};

}  // namespace gridstep
