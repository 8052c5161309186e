#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shapes/digital/digital_set.hpp"
#include "shapes/files/byte_reader.hpp"

namespace gridstep {

/// An image of integer grey values, row by row from the top.
struct GreyImage {
  std::string name;  ///< what errors call it
  int width = 0, height = 0;
  std::vector<std::uint16_t> values;

  int at(int x, int row) const { return values[std::size_t(row) * std::size_t(width) + std::size_t(x)]; }
};

/// Reads a PGM image (P2, P5; values 0 to a maximum of at most 65535, with two bytes a value, the higher
/// first, above 255) or a PBM image (P1, P4), with comments. In a PGM image 0 is black; in a PBM image black
/// is 1 and white is 0, as the file has them, so that [1, 1] is the drawing. What follows the last pixel is
/// ignored. Cost O(pixels).
/// @throws InputError naming the file and what is wrong with it.
GreyImage read_image(ByteReader& file);
GreyImage read_image(const std::string& path);

/// The pixels with low <= value <= high. The y axis points up: the pixel x of row r is the point (x, height -
/// 1 - r). Outside of the image is background: foreground that touches the border has its boundary there.
/// Cost O(pixels).
/// @throws InputError where there is no such pixel.
DigitalSet<2> threshold(const GreyImage& image, double low, double high);

}  // namespace gridstep
