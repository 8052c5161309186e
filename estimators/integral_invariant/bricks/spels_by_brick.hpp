#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "shapes/digital/brick.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep::bricks {

/// Distinct spels, grouped by the brick they lie in: bricks in the order in which they were first seen, spels of
/// a brick by bit.
template <int d>
class SpelsByBrick {
 public:
  struct Source {
    LatticePoint<d> brick;
    std::size_t begin = 0;                  ///< position of its first spel; valid after number()
    std::array<std::uint16_t, 8> before{};  ///< spels in earlier words
    Brick<d> spels{};
  };
  /// Where the last spel was found: successive ones are mostly in one brick.
  struct Memo {
    LatticePoint<d> origin = LatticePoint<d>::Constant(std::numeric_limits<int>::min());  ///< of the brick
    std::uint32_t source = 0;
  };

  SpelsByBrick() : table_(64, kNone) {}

  void insert(const LatticePoint<d>& spel, Memo& memo) {
    int bit = bit_from(memo.origin, spel);
    if (bit < 0) {
      memo = insert_brick(Brick<d>::of(spel));
      bit = Brick<d>::bit(spel);
    }
    sources_[memo.source].spels.words[std::size_t(bit) >> 6] |= std::uint64_t{1} << (bit & 63);
  }
  /// Inserts all that others hold.
  void merge(std::span<const SpelsByBrick> others);
  /// Numbers the spels; to be called between the last insert() and the first position().
  void number();
  /// Position of a spel that was inserted.
  std::size_t position(const LatticePoint<d>& spel, Memo& memo) const {
    int bit = bit_from(memo.origin, spel);
    if (bit < 0) {
      memo = find_brick(Brick<d>::of(spel));
      bit = Brick<d>::bit(spel);
    }
    const Source& source = sources_[memo.source];
    const auto word = std::size_t(bit) >> 6;
    const std::uint64_t earlier = source.spels.words[word] & ((std::uint64_t{1} << (bit & 63)) - 1);
    return source.begin + source.before[word] + std::size_t(count_bits(earlier));
  }

  const std::vector<Source>& sources() const { return sources_; }
  std::size_t size() const { return size_; }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// The bit of a spel in the brick of that origin, or -1 where it lies in another brick.
  static int bit_from(const LatticePoint<d>& origin, const LatticePoint<d>& spel) {
    unsigned beyond = 0, bit = 0;
    for (int k = 0; k < d; ++k) {
      const unsigned offset = unsigned(spel[k]) - unsigned(origin[k]);
      beyond |= offset >> Brick<d>::kShift[std::size_t(k)];
      bit += offset << Brick<d>::stride_shift(k);
    }
    return beyond == 0 ? int(bit) : -1;
  }

  Memo insert_brick(const LatticePoint<d>& brick);
  Memo find_brick(const LatticePoint<d>& brick) const;
  /// The number of the source of that brick, a new one where there is none.
  std::uint32_t source_of(const LatticePoint<d>& brick);
  /// Slot of the table that holds the brick, or where it would go.
  std::size_t slot(const LatticePoint<d>& brick) const;
  /// Into a table of that size, a power of two.
  void rehash(std::size_t size);

  std::vector<Source> sources_;
  std::vector<std::uint32_t> table_;  // open addressing, a power of two, at most half full
  std::size_t size_ = 0;
};

extern template class SpelsByBrick<2>;
extern template class SpelsByBrick<3>;

}  // namespace gridstep::bricks
