#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "shapes/files/byte_reader.hpp"

namespace gridstep {

/// The ways in which the formats of the PGM family write their values.
enum class PnmEncoding { bit_characters, decimals, bits, bytes };

/// A line of a format's table: the word a file begins with, and what follows the header.
struct PnmMagic {
  std::string_view word;
  PnmEncoding encoding;
};

/// A grid of unsigned values, the first side counting first.
struct PnmGrid {
  std::vector<int> sides;
  int maximum = 1;
  std::vector<std::uint16_t> values;
};

/// Reads a file of the PGM family: magic word, the sides, the maximum value (not of bits), the values; comments from
/// # to the end of the line. Values above 255 have two bytes, the higher first. What follows the last value is
/// ignored.
/// @param side_names as messages call them: one a side
/// @throws InputError naming the file and what is wrong with it; `what` is the format's name for messages.
PnmGrid read_pnm(ByteReader& file, std::span<const PnmMagic> magics,
                 std::span<const std::string_view> side_names, std::string_view what);

}  // namespace gridstep
