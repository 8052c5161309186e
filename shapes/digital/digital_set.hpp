#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapes/base/contracts.hpp"
#include "shapes/digital/brick.hpp"

namespace gridstep {

/// A finite set of digital points, stored as bit bricks under a sparse index of two levels.
///
/// A brick is empty, full or mixed, and only mixed bricks are stored; a page indexes kPageSide^d bricks, and
/// pages that are all empty or all full are not stored either. Memory is O(h^-(d-1)) but for the top level of
/// the index, which is a dense array of 4 bytes for each page of the domain (2^15 points in 3D, 2^19 in 2D).
/// Points outside the domain are not in the set. Reading is thread-safe; writing is not.
template <int d>
class DigitalSet {
 public:
  static constexpr int kPageShift = d == 2 ? 5 : 3;  ///< log2 of the bricks in a page, per direction
  static constexpr int kPageSide = 1 << kPageShift;
  static constexpr int kBricksInPage = 1 << (d * kPageShift);
  static constexpr std::int32_t kEmpty = -1, kFull = -2;  ///< states of a brick or page that is not stored

  /// The empty set over a domain, which is enlarged to whole pages.
  /// @throws InputError where the top level of the index alone would need more than 2^31 entries.
  explicit DigitalSet(const LatticeBox<d>& domain);

  const LatticeBox<d>& domain() const { return domain_; }
  /// The pages, and the bricks, that cover the domain.
  const LatticeBox<d>& page_box() const { return pages_; }
  LatticeBox<d> brick_box() const;

  bool contains(const LatticePoint<d>& z) const {
    const std::int32_t s = state(Brick<d>::of(z));
    return s < 0 ? s == kFull : bricks_[std::size_t(s)].test(Brick<d>::bit(z));
  }
  void set(const LatticePoint<d>& z, bool value);
  /// Number of points.
  std::int64_t size() const;

  /// kEmpty, kFull, or the number of a stored brick; bricks outside the domain are empty.
  std::int32_t state(const LatticePoint<d>& brick) const {
    const std::int32_t page = page_state(page_of(brick));
    return page < 0 ? page : slots_[std::size_t(page) * kBricksInPage + std::size_t(index_in_page(brick))];
  }
  /// The brick of a state; valid until the set is written to.
  const Brick<d>& brick_of(std::int32_t state) const {
    static constexpr Brick<d> kNone{}, kAll = Brick<d>::full();
    return state == kEmpty ? kNone : state == kFull ? kAll : bricks_[std::size_t(state)];
  }
  const Brick<d>& brick(const LatticePoint<d>& brick) const { return brick_of(state(brick)); }
  void set_brick(const LatticePoint<d>& brick, const Brick<d>& bits);
  std::int32_t page_state(const LatticePoint<d>& page) const {
    const std::int64_t index = page_index(page);
    return index < 0 ? kEmpty : top_[std::size_t(index)];
  }
  /// The states of its bricks in raster order, for a page of a state that is not negative.
  std::span<const std::int32_t, kBricksInPage> states_in_page(std::int32_t page) const {
    return std::span<const std::int32_t, kBricksInPage>(&slots_[std::size_t(page) * kBricksInPage],
                                                        kBricksInPage);
  }
  void set_page(const LatticePoint<d>& page, std::int32_t state);
  /// Stores a page at once: for each of its bricks in raster order, kEmpty, kFull, or the number of its bits in
  /// `bricks`. The page must not be stored yet.
  void set_page(const LatticePoint<d>& page, std::span<const std::int32_t> states,
                std::span<const Brick<d>> bricks);

  /// The page of a brick, and the number of the brick there.
  static LatticePoint<d> page_of(const LatticePoint<d>& brick) {
    LatticePoint<d> page;
    for (int k = 0; k < d; ++k) page[k] = brick[k] >> kPageShift;
    return page;
  }
  static int index_in_page(const LatticePoint<d>& brick) {
    int index = 0;
    for (int k = d - 1; k >= 0; --k) index = (index << kPageShift) | (brick[k] & (kPageSide - 1));
    return index;
  }

  /// Bytes held.
  std::size_t memory() const;

 private:
  /// Its place in the top level, or -1.
  std::int64_t page_index(const LatticePoint<d>& page) const {
    if (!pages_.contains(page)) return -1;
    std::int64_t index = 0;
    for (int k = d - 1; k >= 0; --k)
      index = index * (pages_.hi[k] - pages_.lo[k] + 1) + (page[k] - pages_.lo[k]);
    return index;
  }
  std::int32_t& slot(const LatticePoint<d>& brick);

  LatticeBox<d> domain_, pages_;
  std::vector<std::int32_t> top_;    // for each page: kEmpty, kFull, or its number
  std::vector<std::int32_t> slots_;  // for each stored page, for each brick: kEmpty, kFull, or its number
  std::vector<Brick<d>> bricks_;
};

/// Calls visit(brick coordinates) for every brick that holds a point of the set with a neighbour outside it,
/// and maybe for some more: raster order of pages, then of bricks. Cost O(h^-(d-1)) beside the scan of the
/// top level.
template <int d, class Visit>
void for_each_border_brick(const DigitalSet<d>& set, Visit visit) {
  const auto has_other_neighbour = [](const auto& state_of, LatticePoint<d> b) {
    for (int axis = 0; axis < d; ++axis)
      for (const int direction : {-1, +1}) {
        LatticePoint<d> next = b;
        next[axis] += direction;
        if (state_of(next) != DigitalSet<d>::kFull) return true;
      }
    return false;
  };
  const auto page_state = [&](const LatticePoint<d>& page) { return set.page_state(page); };
  const auto brick_state = [&](const LatticePoint<d>& brick) { return set.state(brick); };
  for_each_point(set.page_box(), [&](const LatticePoint<d>& page) {
    const std::int32_t state = page_state(page);
    if (state == DigitalSet<d>::kEmpty) return;
    if (state == DigitalSet<d>::kFull && !has_other_neighbour(page_state, page)) return;
    const LatticePoint<d> first = page * DigitalSet<d>::kPageSide;
    std::size_t i = 0;
    for_each_point(LatticeBox<d>{first, first.array() + (DigitalSet<d>::kPageSide - 1)},
                   [&](const LatticePoint<d>& brick) {
                     const std::int32_t own = state < 0 ? state : set.states_in_page(state)[i++];
                     if (own == DigitalSet<d>::kEmpty) return;
                     if (own == DigitalSet<d>::kFull && !has_other_neighbour(brick_state, brick)) return;
                     visit(brick);
                   });
  });
}

/// Calls visit(z) for every point of the set, brick by brick.
template <int d, class Visit>
void for_each_point_of(const DigitalSet<d>& set, Visit visit) {
  for_each_point(set.brick_box(), [&](const LatticePoint<d>& b) {
    if (set.state(b) == DigitalSet<d>::kEmpty) return;
    const Brick<d> brick = set.brick(b);
    const LatticePoint<d> origin = Brick<d>::origin(b);
    for_each_bit(brick, [&](int bit) { visit(LatticePoint<d>(origin + Brick<d>::offset(bit))); });
  });
}

/// The points of a box that are not in the set.
template <int d>
DigitalSet<d> complement(const DigitalSet<d>& set, const LatticeBox<d>& box);

extern template class DigitalSet<2>;
extern template class DigitalSet<3>;

}  // namespace gridstep
