#include "estimators/integral_invariant/radial/line_ends.hpp"

#include <bit>
#include <cstdlib>

namespace gridstep {

namespace {

constexpr std::uint64_t kFirstOfLines = 0x0101010101010101;

template <class Visit>
void for_each_bit_of(std::uint64_t word, Visit visit) {
  for (; word != 0; word &= word - 1) visit(std::countr_zero(word));
}

/// Between brick 0 and the brick `offset` bricks away along an axis, from point to nearest point.
int gap(int offset) {
  return offset == 0 ? 0 : 8 * std::abs(offset) - 7;
}

}  // namespace

void Ends::reset(std::size_t lines) {
  unsorted_.clear();
  begin_.assign(lines + 1, 0);
}

void Ends::sort() {
  for (const Unsorted& one : unsorted_) ++begin_[one.line];
  std::uint32_t total = 0;
  for (std::uint32_t& begin : begin_) begin = total += begin;
  ends_.resize(unsorted_.size() + kAhead);
  // From behind, so that each line's count ends up as its beginning.
  for (auto one = unsorted_.rbegin(); one != unsorted_.rend(); ++one) ends_[--begin_[one->line]] = one->end;
}

void LineEnds::build(const DigitalSet<3>& set, const LatticePoint<3>& source, int reach) {
  const auto n = std::size_t(lines());
  enters.reset(n * n);
  leaves.reset(n * n);
  face_enters.reset(n);
  face_leaves.reset(n);
  face_.assign(n * n, 0);
  for (int z = -most_; z <= most_; ++z)
    for (int y = -most_; y <= most_; ++y)
      if (gap(y) * gap(y) + gap(z) * gap(z) <= reach * reach) add_row(set, source, y, z);
  enters.sort();
  leaves.sort();

  for (std::size_t z = 0; z < n; ++z) {
    bool inside = false;
    for (std::size_t y = 0; y < n; ++y) {
      if ((face_[z * n + y] != 0) == inside) continue;
      inside = !inside;
      const int place = int(y) + first(), line = int(z) + first();
      (inside ? face_enters : face_leaves).add(z, {place + face_stride_ * line, line});
    }
    // Nothing of a ball is on the last line, nor beyond it.
  }
  face_enters.sort();
  face_leaves.sort();
}

void LineEnds::add_row(const DigitalSet<3>& set, const LatticePoint<3>& source, int y, int z) {
  const auto n = std::size_t(lines());
  const std::size_t corner = std::size_t(8 * (z + most_)) * n + std::size_t(8 * (y + most_));
  // Of each line, whether the last point so far is in the set, in the line's first bit; word by word.
  std::array<std::uint64_t, 8> inside{};
  std::int32_t all = DigitalSet<3>::kEmpty;  // what all lines are, if it is the same
  for (int x = -most_; x <= most_; ++x) {
    const std::int32_t state = set.state(source + LatticePoint<3>(x, y, z));
    const bool first = x == -most_;
    if (state < 0 && state == all && !first) continue;
    const Brick<3>& brick = set.brick_of(state);
    for (std::size_t slice = 0; slice < 8; ++slice) {
      const std::uint64_t bits = brick.words[slice];
      if (first) {
        inside[slice] = bits & kFirstOfLines;
        for_each_bit_of(inside[slice],
                        [&](int bit) { face_[corner + slice * n + std::size_t(bit / 8)] = 1; });
      }
      const std::uint64_t before = ((bits << 1) & ~kFirstOfLines) | inside[slice];
      const auto add = [&](Ends& ends, std::uint64_t places) {
        for_each_bit_of(places, [&](int bit) {
          const int line = 8 * y + bit / 8;
          ends.add(corner + slice * n + std::size_t(bit / 8),
                   {strides_[0] * (8 * x + bit % 8) + strides_[1] * line + strides_[2] * (8 * z + int(slice)),
                    line});
        });
      };
      add(enters, bits & ~before);
      add(leaves, before & ~bits);
      inside[slice] = (bits >> 7) & kFirstOfLines;
    }
    all = state < 0 ? state : 0;
  }
}

}  // namespace gridstep
