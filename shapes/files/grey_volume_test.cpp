#include "shapes/files/grey_volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shapes/base/random.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/files/formats.hpp"
#include "shapes/files/testing_volumes.hpp"

namespace gridstep {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
GreyVolume row_of(VoxelType type, const std::vector<T>& values) {
  GreyVolume volume{"row", {int(values.size()), 1, 1}, 1, type, {}};
  for (const T value : values) volume.bytes += bytes_in(value);
  return volume;
}

/// The x of the points in the set.
std::vector<int> where(const DigitalSet<3>& set) {
  std::vector<int> result;
  for_each_point_of(set, [&](const LatticePoint<3>& z) { result.push_back(z[0]); });
  return result;
}

TEST(GreyVolume, ThresholdKeepsBothBoundsOfEveryType) {
  const auto check = [](const GreyVolume& volume) {
    EXPECT_EQ(where(threshold(volume, {2, 4})), (std::vector{1, 2, 3})) << name_of(volume.type);
    EXPECT_EQ(where(threshold(volume, {1.5, 3.5})), (std::vector{1, 2})) << name_of(volume.type);
    EXPECT_EQ(where(threshold(volume, {-kInfinity, 1})), (std::vector{0})) << name_of(volume.type);
    EXPECT_EQ(where(threshold(volume, {5, kInfinity})), (std::vector{4})) << name_of(volume.type);
    EXPECT_EQ(failure([&] { threshold(volume, {6, 1e30}); }), "row: no voxel in [6, 1e+30]");
    EXPECT_EQ(failure([&] { threshold(volume, {-1e30, 0.5}); }), "row: no voxel in [-1e+30, 0.5]");
    EXPECT_EQ(failure([&] { threshold(volume, {1.25, 1.75}); }), "row: no voxel in [1.25, 1.75]");
  };
  for (const VoxelType type : kVoxelTypes)
    with_type(type, [&]<class T>(T) { check(row_of<T>(type, {1, 2, 3, 4, 5})); });
}

TEST(GreyVolume, BoundsAreComparedExactly) {
  const GreyVolume large = row_of<std::uint64_t>(VoxelType::uint64, {(1ull << 53) + 1, 1ull << 53, ~0ull});
  EXPECT_EQ(where(threshold(large, {0x1p53, 0x1p53})), (std::vector{1}));
  EXPECT_EQ(where(threshold(large, {0x1p53 + 2, 0x1p64})), (std::vector{2}));
  const GreyVolume least =
      row_of<std::int64_t>(VoxelType::int64, {std::numeric_limits<std::int64_t>::min(), 0});
  EXPECT_EQ(where(threshold(least, {-0x1p63, -0x1p63})), (std::vector{0}));
  const GreyVolume tenth = row_of<float>(VoxelType::float32, {0.1f, std::nextafter(0.1f, 0.0f), NAN});
  EXPECT_GT(double(0.1f), 0.1);
  EXPECT_EQ(where(threshold(tenth, {0.1, 1})), (std::vector{0}));
  EXPECT_EQ(where(threshold(tenth, {0, 0.1})), (std::vector{1}));
}

// Also where the volume fills whole bricks and pages of the set.
TEST(GreyVolume, OutsideOfTheVolumeIsBackground) {
  for (const LatticePoint<3>& n : {LatticePoint<3>(3, 2, 1), {8, 8, 8}, {64, 64, 64}, {65, 9, 1}}) {
    GreyVolume volume{"white", n, 1, VoxelType::uint8, {}};
    volume.bytes.assign(volume.voxels(), '\1');
    const DigitalSet<3> set = threshold(volume, foreground(volume));
    EXPECT_EQ(set.size(), std::int64_t(volume.voxels()));
    EXPECT_EQ(boundary(set).size(), std::size_t(2 * (n[0] * n[1] + n[1] * n[2] + n[2] * n[0])));
  }
}

TEST(GreyVolume, ThresholdIsThatOfEveryVoxel) {
  GreyVolume volume{"random", {13, 70, 9}, 1, VoxelType::uint8, {}};
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < volume.voxels(); ++i) {
    state = state * 1664525 + 1013904223;
    volume.bytes += char(state >> 24);
  }
  const DigitalSet<3> set = threshold(volume, {100, 200});
  for_each_point(LatticeBox<3>{{-1, -1, -1}, {13, 70, 9}}, [&](const LatticePoint<3>& z) {
    const bool inside = LatticeBox<3>{{0, 0, 0}, volume.extent.array() - 1}.contains(z);
    EXPECT_EQ(set.contains(z), inside && volume.at(z) >= 100 && volume.at(z) <= 200);
  });
}

TEST(GreyVolume, ForegroundOfSegmentedVolumesAlone) {
  EXPECT_EQ(foreground(row_of<std::uint8_t>(VoxelType::uint8, {0, 255, 0})).low, 255);
  EXPECT_EQ(foreground(row_of<std::int16_t>(VoxelType::int16, {0, -3})).high, -3);
  const GreyVolume empty = row_of<std::uint8_t>(VoxelType::uint8, {0, 0});
  EXPECT_EQ(failure([&] { threshold(empty, foreground(empty)); }), "row: no voxel in [1, 1]");
  EXPECT_EQ(
      failure([] {
        foreground(row_of<std::uint8_t>(VoxelType::uint8, {9, 1, 0}));
      }),
      "row: a grey volume, with values from 0 to 9; --threshold LOW,HIGH says which are the foreground");
}

TEST(GreyVolume, OtherTypesHoldTheSameValues) {
  const GreyVolume small = row_of<std::uint8_t>(VoxelType::uint8, {0, 1, 127});
  for (const VoxelType type : kVoxelTypes) {
    const GreyVolume other = as_type(small, type);
    EXPECT_EQ(other.type, type);
    EXPECT_EQ(as_type(other, VoxelType::uint8).bytes, small.bytes);
  }
  const auto refused = [](const GreyVolume& volume, VoxelType type) {
    return !failure([&] { as_type(volume, type); }).empty();
  };
  EXPECT_EQ(failure([] {
              as_type(row_of<std::int16_t>(VoxelType::int16, {3, 256}), VoxelType::uint8);
            }),
            "row: the value 256 does not fit uint8; --threshold LOW,HIGH makes it 0 and 1");
  EXPECT_TRUE(refused(row_of<std::int16_t>(VoxelType::int16, {-1}), VoxelType::uint64));
  EXPECT_TRUE(refused(row_of<double>(VoxelType::float64, {0.5}), VoxelType::int32));
  EXPECT_TRUE(refused(row_of<double>(VoxelType::float64, {NAN}), VoxelType::int32));
  EXPECT_TRUE(refused(row_of<double>(VoxelType::float64, {0x1p64}), VoxelType::uint64));
  EXPECT_TRUE(refused(row_of<double>(VoxelType::float64, {0.1}), VoxelType::float32));
  EXPECT_TRUE(refused(row_of<std::uint64_t>(VoxelType::uint64, {~0ull}), VoxelType::float64));
  EXPECT_TRUE(refused(row_of<std::int32_t>(VoxelType::int32, {(1 << 24) + 1}), VoxelType::float32));
  EXPECT_FALSE(refused(row_of<double>(VoxelType::float64, {-0x1p63}), VoxelType::int64));
}

TEST(GreyVolume, WhatIsWrittenIsReadAgain) {
  const auto written = [](auto write, const GreyVolume& volume) {
    std::string content;
    write(volume, [&](std::string_view bytes) { content += bytes; });
    return content;
  };
  for (const VoxelType type : kVoxelTypes) {
    GreyVolume volume = as_type({"small", {2, 3, 4}, 0.5, VoxelType::uint8, kVoxels}, type);
    const GreyVolume nrrd = volume_in(read_nrrd, written(write_nrrd, volume));
    EXPECT_EQ(nrrd.type, type);
    EXPECT_EQ(nrrd.spacing, 0.5);
    EXPECT_EQ(nrrd.bytes, volume.bytes);
    const auto as_raw = [&](ByteReader& file) {
      return read_raw(file, {{2, 3, 4}, type, std::endian::little});
    };
    EXPECT_EQ(volume_in(as_raw, written(write_raw, volume)).bytes, volume.bytes);
    EXPECT_EQ(volume_in(read_vol, written(write_vol, volume)).bytes, kVoxels);
    EXPECT_EQ(as_type(volume_in(read_longvol, written(write_longvol, volume)), VoxelType::uint8).bytes,
              kVoxels);
    EXPECT_EQ(as_type(volume_in(read_pgm3d, written(write_pgm3d, volume)), VoxelType::uint8).bytes, kVoxels);
  }
}

TEST(GreyVolume, RawFilesHaveTheirLength) {
  const auto error = [](const RawLayout& layout, const std::string& content) {
    return refusal([&](ByteReader& file) { return read_raw(file, layout); }, content);
  };
  EXPECT_EQ(error({{2, 3, 4}}, kVoxels), "");
  EXPECT_EQ(error({{2, 3, 5}}, kVoxels),
            "truncated: its 2 x 3 x 5 voxels of uint8 need 30 bytes, and it holds no more than 24");
  EXPECT_EQ(error({{2, 3, 3}}, kVoxels), "its 2 x 3 x 3 voxels of uint8 need 18 bytes, but it has 24");
  EXPECT_EQ(error({{2, 3, 0}}, kVoxels), "size in z = 0: must be in [1, 536870912]");
  EXPECT_EQ(error({{2, 3, -4}}, kVoxels), "size in z = -4: must be in [1, 536870912]");
  EXPECT_EQ(error({{3, 4, 1}, VoxelType::uint16}, kVoxels), "");
  const RawLayout big{{3, 4, 1}, VoxelType::uint16, std::endian::big};
  EXPECT_EQ(volume_in([&](ByteReader& file) { return read_raw(file, big); }, kVoxels).at({1, 0, 0}), 0x0203);
}

}  // namespace
}  // namespace gridstep
