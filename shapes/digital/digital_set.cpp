#include "shapes/digital/digital_set.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gridstep {

template <int d>
DigitalSet<d>::DigitalSet(const LatticeBox<d>& domain) {
  expects(!domain.empty(), "a domain that is not empty");
  pages_ = {page_of(Brick<d>::of(domain.lo)), page_of(Brick<d>::of(domain.hi))};
  const LatticePoint<d> behind = pages_.hi.array() + 1;
  domain_ = {Brick<d>::origin(pages_.lo * kPageSide), Brick<d>::origin(behind * kPageSide).array() - 1};
  if (pages_.volume() >= 0x1p31)
    throw InputError(fmt::format("a grid of {:.3g} points is too large to index", domain_.volume()));
  top_.assign(std::size_t(pages_.volume()), kEmpty);
}

template <int d>
LatticeBox<d> DigitalSet<d>::brick_box() const {
  return {Brick<d>::of(domain_.lo), Brick<d>::of(domain_.hi)};
}

template <int d>
std::int32_t& DigitalSet<d>::slot(const LatticePoint<d>& brick) {
  const std::int64_t index = page_index(page_of(brick));
  expects(index >= 0, "a brick inside the domain");
  std::int32_t& page = top_[std::size_t(index)];
  if (page < 0) {
    const std::int32_t uniform = page;
    page = std::int32_t(slots_.size() / kBricksInPage);
    slots_.resize(slots_.size() + kBricksInPage, uniform);
  }
  return slots_[std::size_t(page) * kBricksInPage + std::size_t(index_in_page(brick))];
}

template <int d>
void DigitalSet<d>::set_brick(const LatticePoint<d>& brick, const Brick<d>& bits) {
  std::int32_t& s = slot(brick);
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
void DigitalSet<d>::set_page(const LatticePoint<d>& page, std::int32_t state) {
  expects(state == kEmpty || state == kFull, "a uniform page");
  const std::int64_t index = page_index(page);
  expects(index >= 0 && top_[std::size_t(index)] < 0, "a page inside the domain that is not stored");
  top_[std::size_t(index)] = state;
}

template <int d>
void DigitalSet<d>::set_page(const LatticePoint<d>& page, std::span<const std::int32_t> states,
                             std::span<const Brick<d>> bricks) {
  const std::int64_t index = page_index(page);
  expects(index >= 0 && top_[std::size_t(index)] < 0, "a page inside the domain that is not stored");
  expects(states.size() == kBricksInPage, "a state for each brick of a page");
  top_[std::size_t(index)] = std::int32_t(slots_.size() / kBricksInPage);
  const auto before = std::int32_t(bricks_.size());
  slots_.resize(slots_.size() + kBricksInPage);
  std::transform(states.begin(), states.end(), slots_.end() - kBricksInPage,
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
  for (const std::int32_t page : top_)
    if (page == kFull) result += std::int64_t{kBricksInPage} * Brick<d>::kBits;
  for (const std::int32_t s : slots_)
    if (s == kFull) result += Brick<d>::kBits;
  for (const Brick<d>& brick : bricks_) result += brick.count();
  return result;
}

template <int d>
std::size_t DigitalSet<d>::memory() const {
  return (top_.capacity() + slots_.capacity()) * sizeof(std::int32_t) + bricks_.capacity() * sizeof(Brick<d>);
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
