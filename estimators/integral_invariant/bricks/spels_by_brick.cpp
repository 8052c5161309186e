#include "estimators/integral_invariant/bricks/spels_by_brick.hpp"

#include <algorithm>
#include <bit>

namespace gridstep::bricks {

template <int d>
std::size_t SpelsByBrick<d>::slot(const LatticePoint<d>& brick) const {
  static constexpr std::array<std::uint64_t, 3> kFactors{0x9e3779b97f4a7c15u, 0xbf58476d1ce4e5b9u,
                                                         0x94d049bb133111ebu};
  std::uint64_t hash = 0;  // not a sum, which puts the bricks of a plane in few places
  for (int k = 0; k < d; ++k) hash ^= std::uint32_t(brick[k]) * kFactors[std::size_t(k)];
  std::size_t i = hash >> std::countl_zero(table_.size() - 1);  // the upper bits depend on all others
  while (table_[i] != kNone && sources_[table_[i]].brick != brick) i = (i + 1) & (table_.size() - 1);
  return i;
}

template <int d>
void SpelsByBrick<d>::rehash(std::size_t size) {
  table_.assign(size, kNone);
  for (std::uint32_t i = 0; i < sources_.size(); ++i) table_[slot(sources_[i].brick)] = i;
}

template <int d>
std::uint32_t SpelsByBrick<d>::source_of(const LatticePoint<d>& brick) {
  std::size_t i = slot(brick);
  if (table_[i] == kNone) {
    if (2 * (sources_.size() + 1) > table_.size()) {
      rehash(2 * table_.size());
      i = slot(brick);
    }
    sources_.push_back({brick});
    table_[i] = std::uint32_t(sources_.size() - 1);
  }
  return table_[i];
}

template <int d>
auto SpelsByBrick<d>::insert_brick(const LatticePoint<d>& brick) -> Memo {
  return {Brick<d>::origin(brick), source_of(brick)};
}

template <int d>
auto SpelsByBrick<d>::find_brick(const LatticePoint<d>& brick) const -> Memo {
  return {Brick<d>::origin(brick), table_[slot(brick)]};
}

template <int d>
void SpelsByBrick<d>::merge(std::span<const SpelsByBrick> others) {
  if (others.empty()) return;
  std::size_t most = sources_.size();
  for (const SpelsByBrick& other : others) most += other.sources_.size();
  sources_.reserve(most);
  rehash(std::max(table_.size(), std::bit_ceil(2 * most)));
  for (const SpelsByBrick& other : others)
    for (const Source& source : other.sources_) {
      Brick<d>& own = sources_[source_of(source.brick)].spels;
      for (std::size_t w = 0; w < own.words.size(); ++w) own.words[w] |= source.spels.words[w];
    }
}

template <int d>
void SpelsByBrick<d>::number() {
  size_ = 0;
  for (Source& source : sources_) {
    source.begin = size_;
    int count = 0;
    for (std::size_t w = 0; w < 8; ++w) {
      source.before[w] = std::uint16_t(count);
      count += count_bits(source.spels.words[w]);
    }
    size_ += std::size_t(count);
  }
}

template class SpelsByBrick<2>;
template class SpelsByBrick<3>;

}  // namespace gridstep::bricks
