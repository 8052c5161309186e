#include <gtest/gtest.h>

#include "shapes/files/formats.hpp"
#include "shapes/files/testing_volumes.hpp"

namespace gridstep {
namespace {

using namespace std::string_literals;

const std::string kSizes = "X: 2\nY: 3\nZ: 4\n";
const std::string kMarks = "Voxel-Size: 1\nAlpha-Color: 0\nVoxel-Endian: 0\nInt-Endian: 0123\n";

std::string error(const std::string& content) {
  return refusal(read_vol, content);
}

void expect_voxels(const GreyVolume& volume) {
  EXPECT_EQ(volume.extent, LatticePoint<3>(2, 3, 4));
  EXPECT_EQ(volume.type, VoxelType::uint8);
  EXPECT_EQ(volume.spacing, 1);
  EXPECT_EQ(volume.bytes, kVoxels);
  EXPECT_EQ(volume.at({1, 2, 3}), 23);
  EXPECT_EQ(volume.at({1, 0, 0}), 1);
  EXPECT_EQ(volume.at({0, 1, 0}), 2);
  EXPECT_EQ(volume.at({0, 0, 1}), 6);
}

TEST(Vol, EveryVersionIsRead) {
  expect_voxels(volume_in(read_vol, kSizes + kMarks + "Version: 2\n.\n" + kVoxels));
  expect_voxels(volume_in(read_vol, kSizes + kMarks + "Version: 3\n.\n" + deflated(kVoxels)));
  expect_voxels(volume_in(read_vol, kSizes + kMarks + ".\n\2\0\0\0\3\0\0\0\4\0\0\0\n"s + kVoxels));
}

TEST(Vol, KeysAsTheyAreFound) {
  expect_voxels(volume_in(read_vol, kSizes + "Version: 2\n.\n" + kVoxels));
  expect_voxels(
      volume_in(read_vol, "Author: Dave: Null\nCenter-X: 30\r\nVersion:2\n" + kSizes + ".\n" + kVoxels));
  expect_voxels(volume_in(read_vol, kSizes + "foo:\nVersion: 2 \nInt-Endian: 3210\n.\n" + kVoxels + "more"));
  expect_voxels(volume_in(read_vol, kSizes + "Int-Endian: 3210\n.\n\0\0\0\2\0\0\0\3\0\0\0\4\n"s + kVoxels));
}

TEST(Vol, HeadersAreChecked) {
  const std::string end = "Version: 2\n.\n" + kVoxels;
  EXPECT_EQ(error("Y: 3\nZ: 4\n" + end), "its header has no X");
  EXPECT_EQ(error("X: two\nY: 3\nZ: 4\n" + end), "X = two: must be an integer");
  EXPECT_EQ(error("X: 2.5\nY: 3\nZ: 4\n" + end), "X = 2.5: must be an integer");
  EXPECT_EQ(error("X: 0\nY: 3\nZ: 4\n" + end), "size in x = 0: must be in [1, 536870912]");
  EXPECT_EQ(error("X: 2\nY: -3\nZ: 4\n" + end), "size in y = -3: must be in [1, 536870912]");
  EXPECT_EQ(error("X: 2\nY: 3\nZ: 99999999999\n" + end),
            "size in z = 99999999999: must be in [1, 536870912]");
  EXPECT_EQ(error("X: 2\nY: 3\nZ: 99999999999999999999\n" + end),
            "Z = 9999999999999999...: must be an integer");
  EXPECT_EQ(error("X: 2\n" + kSizes + end), "header line 2: X is given twice");
  EXPECT_EQ(error(kSizes + "no colon\n" + end), "header line 4: 'no colon' is no 'Key: value'");
  EXPECT_EQ(error(kSizes + ": x\n" + end), "header line 4: ': x' is no 'Key: value'");
  EXPECT_EQ(error(kSizes + "Voxel-Size: 2\n" + end), "Voxel-Size = 2: must be 1");
  EXPECT_EQ(error(kSizes + "Int-Endian: 1032\n" + end),
            "Int-Endian = 1032: must be 0123 (little) or 3210 (big)");
  EXPECT_EQ(error(kSizes + "Version: 4\n.\n" + kVoxels), "Version = 4: must be 2 or 3");
  EXPECT_EQ(error(kSizes + ".\n\3\0\0\0\3\0\0\0\4\0\0\0\n"s + kVoxels),
            "X = 2 in its header, but 3 before its voxels");
  EXPECT_EQ(error(kSizes + ".\n" + kVoxels),
            "no version in its header, and no line end between sizes and voxels");
  EXPECT_EQ(error("\x1b[2J\x01\n" + kSizes + end), "header line 1: '?[2J?' is no 'Key: value'");
}

TEST(Vol, SizesThatTheFileCannotHoldAreRefused) {
  EXPECT_EQ(error("X: 10000\nY: 10000\nZ: 10000\nVersion: 2\n.\n" + kVoxels),
            "truncated: its 10000 x 10000 x 10000 voxels of uint8 need 1000000000000 bytes, and it holds no "
            "more than 24");
  const std::string largest = "X: 536870912\nY: 536870912\nZ: 536870912\n";
  EXPECT_NE(error(largest + "Version: 2\n.\n" + kVoxels).find("truncated: its 536870912 x"),
            std::string::npos);
  EXPECT_NE(error(largest + "Version: 3\n.\n" + deflated(kVoxels)).find("truncated: its 536870912 x"),
            std::string::npos);
}

TEST(Vol, EveryTruncationIsFound) {
  for (const std::string& file : {kSizes + kMarks + "Version: 2\n.\n" + kVoxels,
                                  kSizes + kMarks + "Version: 3\n.\n" + deflated(kVoxels),
                                  kSizes + ".\n\2\0\0\0\3\0\0\0\4\0\0\0\n"s + kVoxels}) {
    EXPECT_EQ(error(file), "");
    for (std::size_t size = 0; size < file.size(); ++size)
      EXPECT_NE(error(file.substr(0, size)), "") << size << " of " << file.size() << " bytes";
  }
}

TEST(Vol, StreamsThatAreCorruptOrDoNotFitAreRefused) {
  const std::string header = kSizes + "Version: 3\n.\n";
  EXPECT_EQ(error(header + "not deflated at all"), "corrupt zlib stream: incorrect header check");
  std::string wrong_sum = deflated(kVoxels);
  wrong_sum.back() ^= 1;
  EXPECT_EQ(error(header + wrong_sum), "corrupt zlib stream: incorrect data check");
  EXPECT_EQ(error(header + deflated(kVoxels + "x")), "its zlib stream holds more than the voxels");
  EXPECT_EQ(error(header + deflated(kVoxels.substr(1))), "truncated: its zlib stream holds 23 of 24 bytes");
  // A bomb: 64 MiB of zeros for 24 voxels. No more of it is read than there are voxels.
  EXPECT_EQ(error(header + deflated(std::string(std::size_t(1) << 26, '\0'))),
            "its zlib stream holds more than the voxels");
}

TEST(Vol, EveryBitCounts) {
  // Whatever one changed bit makes of a file, it is read or refused in one line.
  const std::string file = kSizes + kMarks + "Version: 3\n.\n" + deflated(kVoxels);
  for (std::size_t i = 0; i < 8 * file.size(); ++i) {
    std::string changed = file;
    changed[i / 8] ^= char(1 << i % 8);
    EXPECT_EQ(error(changed).find("no name"), std::string::npos) << i;
    EXPECT_EQ(error(changed).find("more than one line"), std::string::npos) << i;
  }
}

TEST(Longvol, ValuesAre64BitIntegersWhateverTheVoxelSize) {
  const std::string voxels("\1\0\0\0\0\0\0\x80\xff\xff\xff\xff\xff\xff\xff\xff", 16);
  const std::string sizes = "X: 2\nY: 1\nZ: 1\nLvoxel-Size: 4\nLvoxel-Endian: 0\n";
  for (const std::string& file :
       {sizes + "Version: 2\n.\n" + voxels, sizes + "Version: 3\n.\n" + deflated(voxels)}) {
    const GreyVolume volume = volume_in(read_longvol, file);
    EXPECT_EQ(volume.type, VoxelType::uint64);
    EXPECT_EQ(volume.value<std::uint64_t>(0), 0x8000000000000001u);
    EXPECT_EQ(volume.value<std::uint64_t>(1), 0xffffffffffffffffu);
  }
  const GreyVolume swapped = volume_in(read_longvol, sizes + "Int-Endian: 3210\nVersion: 2\n.\n" + voxels);
  EXPECT_EQ(swapped.value<std::uint64_t>(0), 0x0100000000000080u);
  EXPECT_EQ(refusal(read_longvol, sizes + "Version: 2\n.\n" + voxels.substr(1)),
            "truncated: its 2 x 1 x 1 voxels of uint64 need 16 bytes, and it holds no more than 15");
}

}  // namespace
}  // namespace gridstep
