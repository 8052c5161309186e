#include "shapes/files/image_file.hpp"

#include <fmt/format.h>

#include "shapes/files/pnm.hpp"

namespace gridstep {

GreyImage read_image(ByteReader& file) {
  static constexpr PnmMagic magics[] = {{"P1", PnmEncoding::bit_characters},
                                        {"P2", PnmEncoding::decimals},
                                        {"P4", PnmEncoding::bits},
                                        {"P5", PnmEncoding::bytes}};
  static constexpr std::string_view sides[] = {"width", "height"};
  PnmGrid grid = read_pnm(file, magics, sides, "PGM or PBM image (P1, P2, P4 or P5)");
  return {file.name(), grid.sides[0], grid.sides[1], std::move(grid.values)};
}

GreyImage read_image(const std::string& path) {
  ByteReader file = open_file(path);
  return read_image(file);
}

DigitalSet<2> threshold(const GreyImage& image, double low, double high) {
  DigitalSet<2> set({LatticePoint<2>{0, 0}, LatticePoint<2>{image.width - 1, image.height - 1}});
  bool empty = true;
  for (int row = 0; row < image.height; ++row)
    for (int x = 0; x < image.width; ++x)
      if (const int value = image.at(x, row); low <= value && value <= high) {
        set.set({x, image.height - 1 - row}, true);
        empty = false;
      }
  if (empty) throw InputError(fmt::format("{}: no pixel in [{}, {}]", image.name, low, high));
  return set;
}

}  // namespace gridstep
