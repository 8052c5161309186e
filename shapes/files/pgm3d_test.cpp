#include <gtest/gtest.h>

#include "shapes/files/formats.hpp"
#include "shapes/files/testing_volumes.hpp"

namespace gridstep {
namespace {

using namespace std::string_literals;

std::string error(const std::string& content) {
  return refusal(read_pgm3d, content);
}

TEST(Pgm3d, DecimalsAndBytes) {
  std::string decimals;
  for (const char c : kVoxels) decimals += std::to_string(int(c)) + " ";
  for (const std::string& content :
       {"P2\n2 3 4\n255\n" + decimals, "P2-3D\n# comment\n2 3 4 255 " + decimals,
        "P5\n2 3 4\n255\n" + kVoxels, "P5-3D\n#x\n2 3 4\n255\n" + kVoxels, "P3D\n2 3 4\n255\n" + kVoxels}) {
    const GreyVolume volume = volume_in(read_pgm3d, content);
    EXPECT_EQ(volume.extent, LatticePoint<3>(2, 3, 4));
    EXPECT_EQ(volume.type, VoxelType::uint8);
    EXPECT_EQ(volume.bytes, kVoxels);
  }
  const GreyVolume wide = volume_in(read_pgm3d, "P5 2 1 1 300\n\x01\x02\x00\xff"s);
  EXPECT_EQ(wide.type, VoxelType::uint16);
  EXPECT_EQ(wide.at({0, 0, 0}), 258);
  EXPECT_EQ(wide.at({1, 0, 0}), 255);
}

TEST(Pgm3d, FilesAreChecked) {
  EXPECT_EQ(error("P6\n2 3 4\n255\n"), "not a PGM volume (P2, P2-3D, P3D, P5 or P5-3D)");
  EXPECT_EQ(error("P5\n2 3\n"), "truncated: no depth");
  EXPECT_EQ(error("P5\n2 3 0\n255\n"), "depth = 0: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P5\n2 -3 4\n255\n"), "height = -3: must be an integer in [1, 536870912]");
  EXPECT_EQ(error("P5\n10000 10000 10000\n255\n" + kVoxels),
            "truncated: ends before its 10000 x 10000 x 10000 voxels do");
  EXPECT_EQ(error("P2\n536870912 536870912 536870912\n255\n1 1"),
            "truncated: ends before its 536870912 x 536870912 x 536870912 voxels do");
  EXPECT_EQ(error("P5\n2 1 1\n9\n\x09\x0a"), "voxel 1 of row 0 = 10: must be an integer in [0, 9]");
}

TEST(Pgm3d, EveryTruncationIsFound) {
  const std::string content = "P5-3D\n2 3 4\n255\n" + kVoxels;
  for (std::size_t size = 0; size < content.size(); ++size)
    EXPECT_NE(error(content.substr(0, size)), "") << size;
}

}  // namespace
}  // namespace gridstep
