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
/// A brick is empty, full or mixed, and only mixed bricks are stored. A page indexes kPageSide^d bricks, a
/// book kPageSide^d pages; those that were made all empty or all full at once are not stored either. Memory is
/// O(h^-(d-1)) but for an array of 4 bytes for each book of the domain (kBookPoints points).
/// Points outside the domain are not in the set. Reading is thread-safe; writing is not.
template <int d>
class DigitalSet {
 public:
  /// log2 of the bricks in a page, and of the pages in a book, per direction.
  static constexpr int kPageShift = d == 2 ? 5 : 3;
  static constexpr int kPageSide = 1 << kPageShift;
  static constexpr int kBricksInPage = 1 << (d * kPageShift);
  static constexpr double kBookPoints = double(kBricksInPage) * kBricksInPage * Brick<d>::kBits;
  static constexpr std::int32_t kEmpty = -1, kFull = -2;  ///< states of what is not stored

  /// The empty set over a domain, which is enlarged to whole pages.
  /// @throws InputError where the domain has 2^31 books or more.
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
    return page < 0 ? page
                    : brick_states_[std::size_t(page) * kBricksInPage + std::size_t(index_in_page(brick))];
  }
  /// The brick of a state; valid until the set is written to.
  const Brick<d>& brick_of(std::int32_t state) const {
    static constexpr Brick<d> kNone{}, kAll = Brick<d>::full();
    return state == kEmpty ? kNone : state == kFull ? kAll : bricks_[std::size_t(state)];
  }
  const Brick<d>& brick(const LatticePoint<d>& brick) const { return brick_of(state(brick)); }
  void set_brick(const LatticePoint<d>& brick, const Brick<d>& bits);
  /// kEmpty, kFull, or the number of a stored page; pages outside the domain are empty.
  std::int32_t page_state(const LatticePoint<d>& page) const {
    if (!pages_.contains(page)) return kEmpty;
    const std::int32_t book = book_states_[book_index(page)];
    return book < 0 ? book
                    : page_states_[std::size_t(book) * kBricksInPage + std::size_t(index_in_page(page))];
  }
  /// The states of its bricks in raster order, for a page of a state that is not negative.
  std::span<const std::int32_t, kBricksInPage> states_in_page(std::int32_t page) const {
    return std::span<const std::int32_t, kBricksInPage>(&brick_states_[std::size_t(page) * kBricksInPage],
                                                        kBricksInPage);
  }
  /// Pages of a row along x that are not empty: a stored one, or successive full ones.
  struct PageRun {
    int begin, end;      ///< pages along x, `end` excluded
    std::int32_t state;  ///< see page_state()
  };
  /// The runs among the pages from `page` on along x, without page `end`, from left to right.
  /// Cost: the books, and the pages in stored ones.
  std::vector<PageRun> page_runs(LatticePoint<d> page, int end) const;
  /// Calls visit(page) with the first page of each row of pages along x, in raster order, but for rows whose books are
  /// all empty.
  template <class Visit>
  void for_each_row_of_pages(Visit visit) const {
    const auto books_in_row = std::size_t(books_.hi[0] - books_.lo[0] + 1);
    std::vector<bool> has_some(book_states_.size() / books_in_row);
    for (std::size_t book = 0; book < book_states_.size(); ++book)
      if (book_states_[book] != kEmpty) has_some[book / books_in_row] = true;
    LatticeBox<d> rows = pages_;
    rows.hi[0] = rows.lo[0];
    for_each_point(rows, [&](const LatticePoint<d>& page) {
      if (has_some[book_index(page) / books_in_row]) visit(page);
    });
  }
  /// Makes pages of the page box full; none of them may be stored.
  void fill_pages(const LatticeBox<d>& pages);
  /// Stores a page at once: for each of its bricks in raster order, kEmpty, kFull, or the number of its bits in
  /// `bricks`. The page must not be stored yet.
  void set_page(const LatticePoint<d>& page, std::span<const std::int32_t> states,
                std::span<const Brick<d>> bricks);

  /// The page of a brick, and the number of the brick there; in the same way the book of a page.
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
  /// The book of a page in the page box.
  std::size_t book_index(const LatticePoint<d>& page) const {
    std::size_t index = 0;
    for (int k = d - 1; k >= 0; --k)
      index = index * std::size_t(books_.hi[k] - books_.lo[k] + 1) +
              std::size_t((page[k] >> kPageShift) - books_.lo[k]);
    return index;
  }
  /// The state of a page or brick, to be written to; its book, and its page, get stored.
  std::int32_t& stored_page_state(const LatticePoint<d>& page);
  std::int32_t& stored_state(const LatticePoint<d>& brick);

  LatticeBox<d> domain_, pages_, books_;
  // kEmpty, kFull, or a number: for each book; for each stored book, each page; for each stored page, each brick.
  std::vector<std::int32_t> book_states_, page_states_, brick_states_;
  std::vector<Brick<d>> bricks_;
};

/// The states of a brick and of those that share a face with it; quicker than DigitalSet::state() for each, since
/// most are in the same page.
template <int d>
class BrickNeighbours {
 public:
  /// Keeps a reference to the set.
  BrickNeighbours(const DigitalSet<d>& set, const LatticePoint<d>& brick)
      : set_(&set), brick_(brick), page_(set.page_state(DigitalSet<d>::page_of(brick))) {
    if (page_ >= 0) own_ = set.states_in_page(page_).data() + DigitalSet<d>::index_in_page(brick);
  }

  std::int32_t state() const { return own_ ? *own_ : page_; }
  std::int32_t next(int axis, int sign) const {
    constexpr int kLast = DigitalSet<d>::kPageSide - 1;
    if ((brick_[axis] & kLast) == (sign < 0 ? 0 : kLast))
      return set_->state(brick_ + sign * LatticePoint<d>::Unit(axis));
    return own_ ? own_[sign * (1 << (axis * DigitalSet<d>::kPageShift))] : page_;
  }

 private:
  const DigitalSet<d>* set_;
  LatticePoint<d> brick_;
  std::int32_t page_;
  const std::int32_t* own_ = nullptr;  // in the page, if that is stored
};

/// Calls visit(brick coordinates) for every brick that holds a point of the set with a neighbour outside it,
/// and maybe for some more: raster order of pages, then of bricks. Cost O(h^-(d-1)) beside a look at every book,
/// every row of pages and every full page.
template <int d, class Visit>
void for_each_border_brick(const DigitalSet<d>& set, Visit visit) {
  const auto some_is_not_full = [](const auto& next_state) {
    for (int axis = 0; axis < d; ++axis)
      for (const int sign : {-1, +1})
        if (next_state(axis, sign) != DigitalSet<d>::kFull) return true;
    return false;
  };
  const auto visit_page = [&](const LatticePoint<d>& page, std::int32_t state) {
    const auto next_page = [&](int axis, int sign) {
      return set.page_state(page + sign * LatticePoint<d>::Unit(axis));
    };
    if (state == DigitalSet<d>::kFull && !some_is_not_full(next_page)) return;
    const LatticePoint<d> first = page * DigitalSet<d>::kPageSide;
    std::size_t i = 0;
    for_each_point(LatticeBox<d>{first, first.array() + (DigitalSet<d>::kPageSide - 1)},
                   [&](const LatticePoint<d>& brick) {
                     const std::int32_t own = state < 0 ? state : set.states_in_page(state)[i++];
                     if (own == DigitalSet<d>::kEmpty) return;
                     if (own == DigitalSet<d>::kFull) {
                       const BrickNeighbours<d> neighbours(set, brick);
                       const auto next = [&](int axis, int sign) { return neighbours.next(axis, sign); };
                       if (!some_is_not_full(next)) return;
                     }
                     visit(brick);
                   });
  };
  set.for_each_row_of_pages([&](LatticePoint<d> page) {
    for (const auto& run : set.page_runs(page, set.page_box().hi[0] + 1))
      for (page[0] = run.begin; page[0] < run.end; ++page[0]) visit_page(page, run.state);
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
