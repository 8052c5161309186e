#include "estimators/integral_invariant/bricks/brick_sums.hpp"

namespace gridstep::bricks {

namespace {

/// Three sums side by side in one word, so that they are added at once: each below 2^21.
struct Packed {
  static constexpr int kBits = 21;
  static std::uint64_t field(std::uint64_t packed, int i) {
    return (packed >> (kBits * i)) & ((std::uint64_t{1} << kBits) - 1);
  }
};

/// Sums of 1, x, x^2 over the set bits of a byte.
constexpr auto kSumsOfByte = [] {
  std::array<std::uint64_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte)
    for (unsigned x = 0; x < 8; ++x)
      if (byte >> x & 1)
        table[byte] +=
            1 + (std::uint64_t{x} << Packed::kBits) + (std::uint64_t{x * x} << (2 * Packed::kBits));
  return table;
}();

/// Sums of a, i a and i (i - 1) / 2 a over a sequence that is fed from its last element i = 7 to i = 0: sums of
/// sums, without a product.
struct Weighted {
  std::uint64_t plain = 0, first = 0, triangular = 0;

  void add(std::uint64_t a) {
    triangular += first;
    first += plain;
    plain += a;
  }
  std::uint64_t linear() const { return first; }
  /// Of i^2 a.
  std::uint64_t square() const { return 2 * triangular + first; }
};

/// The bits of the i-th byte of the j-th word as points (bit, i, j).
Moments<3> sums_of_bytes(const std::array<std::uint64_t, 8>& words) {
  Weighted slices, rows_of_slices, squared_rows_of_slices;
  for (int z = 7; z >= 0; --z) {
    const std::uint64_t word = words[std::size_t(z)];
    Weighted rows;
    for (int y = 7; y >= 0; --y) rows.add(kSumsOfByte[(word >> (8 * y)) & 255]);
    slices.add(rows.plain);
    rows_of_slices.add(rows.linear());
    squared_rows_of_slices.add(rows.square());
  }
  const auto field = Packed::field;
  return {
      field(slices.plain, 0),
      {field(slices.plain, 1), field(rows_of_slices.plain, 0), field(slices.linear(), 0)},
      {field(slices.plain, 2), field(rows_of_slices.plain, 1), field(slices.linear(), 1),
       field(squared_rows_of_slices.plain, 0), field(rows_of_slices.linear(), 0), field(slices.square(), 0)}};
}

Moments<3> own_sums(const Brick<3>& brick) {
  return sums_of_bytes(brick.words);
}
/// A byte holds x = 8 i + bit.
Moments<2> own_sums(const Brick<2>& brick) {
  const auto [n, first, second] = sums_of_bytes(brick.words);
  const auto& [bit, i, y] = first;
  const auto& [bit_bit, bit_i, bit_y, i_i, i_y, y_y] = second;
  return {n, {8 * i + bit, y}, {64 * i_i + 16 * bit_i + bit_bit, 8 * i_y + bit_y, y_y}};
}

}  // namespace

template <int d>
void add_brick(Moments<d>& sum, const Brick<d>& brick, const LatticePoint<d>& origin) {
  Moments<d> own = own_sums(brick);
  own.move(-origin);
  add(sum, own);
}

template void add_brick(Moments<2>&, const Brick<2>&, const LatticePoint<2>&);
template void add_brick(Moments<3>&, const Brick<3>&, const LatticePoint<3>&);

}  // namespace gridstep::bricks
