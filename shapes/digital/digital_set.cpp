#include "shapes/digital/digital_set.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gridstep {

template <int d>
DigitalSet<d>::DigitalSet(const LatticeBox<d>& domain) {
  expects(!domain.empty(), "a domain that is not empty");
  pages_ = {page_of(Brick<d>::of(domain.lo)), page_of(Brick<d>::of(domain.hi))};
  books_ = {page_of(pages_.lo), page_of(pages_.hi)};
  const LatticePoint<d> behind = pages_.hi.array() + 1;
  domain_ = {Brick<d>::origin(pages_.lo * kPageSide), Brick<d>::origin(behind * kPageSide).array() - 1};
  if (books_.volume() >= 0x1p31)
    throw InputError(fmt::format("a grid of {:.3g} points is too large to index", domain_.volume()));
  book_states_.assign(std::size_t(books_.volume()), kEmpty);
}

template <int d>
LatticeBox<d> DigitalSet<d>::brick_box() const {
  return {Brick<d>::of(domain_.lo), Brick<d>::of(domain_.hi)};
}

namespace {

/// Where a number or uniform state is followed by the states of `count` parts: that of one of them. A uniform whole gets
/// parts first.
std::int32_t& part_state(std::int32_t& whole, std::vector<std::int32_t>& parts, std::size_t count, int part) {
  if (whole < 0) {
    const std::int32_t uniform = whole;
    whole = std::int32_t(parts.size() / count);
    parts.resize(parts.size() + count, uniform);
  }
  return parts[std::size_t(whole) * count + std::size_t(part)];
}

}  // namespace

template <int d>
std::int32_t& DigitalSet<d>::stored_page_state(const LatticePoint<d>& page) {
  expects(pages_.contains(page), "a page inside the domain");
  return part_state(book_states_[book_index(page)], page_states_, kBricksInPage, index_in_page(page));
}

template <int d>
std::int32_t& DigitalSet<d>::stored_state(const LatticePoint<d>& brick) {
  return part_state(stored_page_state(page_of(brick)), brick_states_, kBricksInPage, index_in_page(brick));
}

template <int d>
void DigitalSet<d>::set_brick(const LatticePoint<d>& brick, const Brick<d>& bits) {
  std::int32_t& s = stored_state(brick);
  const bool empty = bits == Brick<d>{};
  if (s >= 0)
    bricks_[std::size_t(s)] = bits;  // keeps its place, even where it became uniform
  else if (empty || bits == Brick<d>::full())
    s = empty ? kEmpty : kFull;
  else {
    s = std::int32_t(bricks_.size());
    bricks_.push_back(bits);
  }
}

template <int d>
auto DigitalSet<d>::page_runs(LatticePoint<d> page, int end) const -> std::vector<PageRun> {
  std::vector<PageRun> runs;
  const auto add = [&](int begin, int behind, std::int32_t state) {
    if (state == kEmpty) return;
    const bool goes_on =
        state == kFull && !runs.empty() && runs.back().state == kFull && runs.back().end == begin;
    if (goes_on)
      runs.back().end = behind;
    else
      runs.push_back({begin, behind, state});
  };
  page[0] = std::max(page[0], pages_.lo[0]);
  end = std::min(end, pages_.hi[0] + 1);
  while (page[0] < end && pages_.contains(page)) {
    const int behind = std::min(((page[0] >> kPageShift) + 1) << kPageShift, end);  // the pages of this book
    const std::int32_t book = book_states_[book_index(page)];
    if (book < 0)
      add(page[0], behind, book);
    else
      for (int x = page[0]; x < behind; ++x) {
        page[0] = x;
        add(x, x + 1, page_states_[std::size_t(book) * kBricksInPage + std::size_t(index_in_page(page))]);
      }
    page[0] = behind;
  }
  return runs;
}

template <int d>
void DigitalSet<d>::fill_pages(const LatticeBox<d>& pages) {
  expects(pages_.contains(pages.lo) && pages_.contains(pages.hi), "pages inside the domain");
  for_each_point(LatticeBox<d>{page_of(pages.lo), page_of(pages.hi)}, [&](const LatticePoint<d>& book) {
    const LatticePoint<d> first = book * kPageSide;
    const LatticeBox<d> all{first, first.array() + (kPageSide - 1)}, filled = all.intersection(pages);
    std::int32_t& state = book_states_[book_index(first)];
    if (state < 0 && filled.extent() == all.extent())
      state = kFull;
    else
      for_each_point(filled, [&](const LatticePoint<d>& page) {
        std::int32_t& page_state = stored_page_state(page);
        expects(page_state < 0, "pages that are not stored");
        page_state = kFull;
      });
  });
}

template <int d>
void DigitalSet<d>::set_page(const LatticePoint<d>& page, std::span<const std::int32_t> states,
                             std::span<const Brick<d>> bricks) {
  std::int32_t& page_state = stored_page_state(page);
  expects(page_state < 0, "a page that is not stored");
  expects(states.size() == kBricksInPage, "a state for each brick of a page");
  page_state = std::int32_t(brick_states_.size() / kBricksInPage);
  const auto before = std::int32_t(bricks_.size());
  brick_states_.resize(brick_states_.size() + kBricksInPage);
  std::transform(states.begin(), states.end(), brick_states_.end() - kBricksInPage,
                 [&](std::int32_t state) { return state < 0 ? state : before + state; });
  bricks_.insert(bricks_.end(), bricks.begin(), bricks.end());
}

template <int d>
void DigitalSet<d>::set(const LatticePoint<d>& z, bool value) {
  const LatticePoint<d> b = Brick<d>::of(z);
  Brick<d> bits = brick(b);
  bits.set(Brick<d>::bit(z), value);
  set_brick(b, bits);
}

template <int d>
std::int64_t DigitalSet<d>::size() const {
  std::int64_t result = 0;
  std::int64_t part = Brick<d>::kBits;
  for (const auto* states : {&brick_states_, &page_states_, &book_states_}) {
    result += part * std::ranges::count(*states, kFull);
    part *= kBricksInPage;
  }
  for (const Brick<d>& brick : bricks_) result += brick.count();
  return result;
}

template <int d>
std::size_t DigitalSet<d>::memory() const {
  return (book_states_.capacity() + page_states_.capacity() + brick_states_.capacity()) *
             sizeof(std::int32_t) +
         bricks_.capacity() * sizeof(Brick<d>);
}

template <int d>
DigitalSet<d> complement(const DigitalSet<d>& set, const LatticeBox<d>& box) {
  DigitalSet<d> result(box);
  for_each_point(box, [&](const LatticePoint<d>& z) {
    if (!set.contains(z)) result.set(z, true);
  });
  return result;
}

template class DigitalSet<2>;
template class DigitalSet<3>;
template DigitalSet<2> complement(const DigitalSet<2>&, const LatticeBox<2>&);
template DigitalSet<3> complement(const DigitalSet<3>&, const LatticeBox<3>&);

}  // namespace gridstep
