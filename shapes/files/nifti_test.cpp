#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "shapes/files/formats.hpp"
#include "shapes/files/testing_volumes.hpp"

namespace gridstep {
namespace {

constexpr std::size_t kDatatype = 70, kPixdim = 76, kVoxOffset = 108, kSlope = 112, kIntercept = 116,
                      kMagic = 344;

std::string error(const std::string& content) {
  return refusal(read_nifti, content);
}

TEST(Nifti, PlainAndGzip) {
  const std::string file = NiftiFile().with(kVoxels);
  for (const std::string& content : {file, deflated(file, Deflate::gzip)}) {
    const GreyVolume volume = volume_in(read_nifti, content);
    EXPECT_EQ(volume.extent, LatticePoint<3>(2, 3, 4));
    EXPECT_EQ(volume.type, VoxelType::uint8);
    EXPECT_EQ(volume.spacing, 1);
    EXPECT_EQ(volume.bytes, kVoxels);
  }
}

TEST(Nifti, ExtensionsAreSkipped) {
  const GreyVolume volume =
      volume_in(read_nifti, NiftiFile().set<float>(kVoxOffset, 368).with(std::string(16, 'x') + kVoxels));
  EXPECT_EQ(volume.bytes, kVoxels);
}

TEST(Nifti, TheOtherByteOrder) {
  // Two int16 of 256 and 1, with every field of the header reversed.
  NiftiFile file;
  const auto reversed = [&]<class T>(std::size_t offset, T value) {
    std::string bytes = bytes_in(value);
    std::reverse(bytes.begin(), bytes.end());
    for (std::size_t i = 0; i < bytes.size(); ++i) file.set<char>(offset + i, bytes[i]);
  };
  reversed(0, std::int32_t{348});
  const std::int16_t dim[] = {3, 2, 1, 1, 1, 1, 1, 1};
  for (std::size_t i = 0; i < 8; ++i) reversed(40 + 2 * i, dim[i]);
  reversed(kDatatype, std::int16_t{4});
  reversed(72, std::int16_t{16});
  for (std::size_t i = 0; i < 8; ++i) reversed(kPixdim + 4 * i, 0.5f);
  reversed(kVoxOffset, 352.0f);
  const std::string native = bytes_in(std::int16_t{256}) + bytes_in(std::int16_t{1});
  const GreyVolume volume = volume_in(read_nifti, file.with({native[1], native[0], native[3], native[2]}));
  EXPECT_EQ(volume.type, VoxelType::int16);
  EXPECT_EQ(volume.spacing, 0.5);
  EXPECT_EQ(volume.at({0, 0, 0}), 256);
  EXPECT_EQ(volume.at({1, 0, 0}), 1);
}

TEST(Nifti, ValuesAreScaled) {
  const GreyVolume volume =
      volume_in(read_nifti, NiftiFile().set<float>(kSlope, 2).set<float>(kIntercept, -10).with(kVoxels));
  EXPECT_EQ(volume.type, VoxelType::float64);
  EXPECT_EQ(volume.at({0, 0, 0}), -10);
  EXPECT_EQ(volume.at({1, 2, 3}), 36);
  EXPECT_EQ(volume_in(read_nifti, NiftiFile().set<float>(kIntercept, 5).with(kVoxels)).bytes, kVoxels);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error(NiftiFile().set(kSlope, nan).with(kVoxels)),
            "scl_slope = nan, scl_inter = 0: must be finite");
}

TEST(Nifti, SpacingOfCubesAlone) {
  const auto spaced = [](float x, float y, float z) {
    NiftiFile file;
    file.set(kPixdim + 4, x).set(kPixdim + 8, y).set(kPixdim + 12, z);
    return file.with(kVoxels);
  };
  EXPECT_EQ(volume_in(read_nifti, spaced(0.25, 0.25, 0.25)).spacing, 0.25);
  EXPECT_EQ(error(spaced(0.5, 0.5, 2)),
            "pixdim = 0.5 x 0.5 x 2: the voxels are no cubes; resample the volume to one spacing first");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error(spaced(nan, nan, nan)), "pixdim = nan x nan x nan: must be positive and finite");
  EXPECT_EQ(error(spaced(0, 0, 0)), "pixdim = 0 x 0 x 0: must be positive and finite");
}

TEST(Nifti, HeadersAreChecked) {
  EXPECT_EQ(error(""), "truncated: ends before its NIfTI-1 header");
  EXPECT_EQ(error(std::string(400, 'x')), "not a NIfTI-1 volume in one file");
  EXPECT_EQ(error(NiftiFile().set<char>(kMagic + 1, 'i').with(kVoxels)), "not a NIfTI-1 volume in one file");
  EXPECT_EQ(error(NiftiFile().dim({4, 2, 3, 4, 5, 1, 1, 1}).with(kVoxels)),
            "dim[4] = 5: must be 1, for a volume of dimension 3");
  EXPECT_EQ(error(NiftiFile().dim({4, 2, 3, 4, 1, 7, 1, 1}).with(kVoxels)), "");
  EXPECT_EQ(error(NiftiFile().dim({3, 2, 0, 4, 1, 1, 1, 1}).with(kVoxels)),
            "size in y = 0: must be in [1, 536870912]");
  EXPECT_EQ(error(NiftiFile().dim({3, 2, 3, -4, 1, 1, 1, 1}).with(kVoxels)),
            "size in z = -4: must be in [1, 536870912]");
  EXPECT_EQ(error(NiftiFile().dim({3, 30000, 30000, 30000, 1, 1, 1, 1}).with(kVoxels)),
            "truncated: its 30000 x 30000 x 30000 voxels of uint8 need 27000000000000 bytes, and it holds no "
            "more than 24");
  EXPECT_EQ(error(NiftiFile().set<std::int16_t>(kDatatype, 32).with(kVoxels)),
            "datatype = 32 (COMPLEX64): must be one of integers, float32 or float64");
  EXPECT_EQ(error(NiftiFile().set<std::int16_t>(kDatatype, 12345).with(kVoxels)),
            "datatype = 12345 (**ILLEGAL**): must be one of integers, float32 or float64");
  for (const float offset : {-1.0f, 347.0f, 352.5f, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_NE(
        error(NiftiFile().set(kVoxOffset, offset).with(kVoxels)).find("must be an integer of at least 348"),
        std::string::npos);
  EXPECT_EQ(error(NiftiFile().set<float>(kVoxOffset, 1e30f).with(kVoxels)),
            "truncated: ends before its voxels");
}

TEST(Nifti, EveryTruncationIsFound) {
  const std::string file = NiftiFile().with(kVoxels);
  for (const std::string& content : {file, deflated(file, Deflate::gzip)}) {
    for (std::size_t size = 0; size < content.size(); ++size)
      EXPECT_NE(error(content.substr(0, size)), "") << size;
  }
}

}  // namespace
}  // namespace gridstep
