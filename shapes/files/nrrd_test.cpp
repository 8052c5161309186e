#include <gtest/gtest.h>

#include "shapes/files/formats.hpp"
#include "shapes/files/testing_volumes.hpp"

namespace gridstep {
namespace {

using namespace std::string_literals;

std::string header(const std::string& more, const std::string& type = "uchar",
                   const std::string& encoding = "raw") {
  return "NRRD0004\n# a comment\ntype: " + type + "\ndimension: 3\nsizes: 2 3 4\nencoding: " + encoding +
         "\n" + more + "\n";
}

std::string error(const std::string& content) {
  return refusal(read_nrrd, content);
}

TEST(Nrrd, RawAndGzip) {
  for (const std::string& file :
       {header("") + kVoxels, header("", "uint8", "gzip") + deflated(kVoxels, Deflate::gzip),
        header("", "unsigned char", "gz") + deflated(kVoxels.substr(0, 9), Deflate::gzip) +
            deflated(kVoxels.substr(9), Deflate::gzip)}) {
    const GreyVolume volume = volume_in(read_nrrd, file);
    EXPECT_EQ(volume.extent, LatticePoint<3>(2, 3, 4));
    EXPECT_EQ(volume.bytes, kVoxels);
    EXPECT_EQ(volume.spacing, 1);
  }
}

TEST(Nrrd, TypesInBothByteOrders) {
  const std::string voxels(96, '\0');
  const auto first = [&](const std::string& type, const std::string& endian, const std::string& value) {
    std::string all = value;
    all.resize(24 * value.size());
    return volume_in(read_nrrd, header("endian: " + endian + "\n", type) + all).at({0, 0, 0});
  };
  EXPECT_EQ(first("short", "little", "\xfe\xff"s), -2);
  EXPECT_EQ(first("short", "big", "\xff\xfe"s), -2);
  EXPECT_EQ(first("unsigned short int", "big", "\x01\x00"s), 256);
  EXPECT_EQ(first("int32_t", "little", "\xff\xff\xff\xff"s), -1);
  EXPECT_EQ(first("uint", "big", "\x00\x01\x00\x00"s), 65536);
  EXPECT_EQ(first("signed long long int", "big", "\xff\xff\xff\xff\xff\xff\xff\xfd"s), -3);
  EXPECT_EQ(first("FLOAT", "big", "\x3f\xc0\0\0"s), 1.5);
  EXPECT_EQ(first("double", "Little", "\0\0\0\0\0\0\xf8\x3f"s), 1.5);
}

TEST(Nrrd, Spacing) {
  const auto spacing = [](const std::string& more) {
    return volume_in(read_nrrd, header(more) + kVoxels).spacing;
  };
  EXPECT_EQ(spacing("spacings: 0.5 0.5 0.5\n"), 0.5);
  EXPECT_EQ(
      spacing("space: left-posterior-superior\nspace directions: (0,0.25,0) (-0.25,0,0) (0, 0, 0.25)\n"),
      0.25);
  EXPECT_NEAR(spacing("space directions: (0.3,0.4,0) (-0.4,0.3,0) (0,0,.5)\n"), 0.5, 1e-15);
  EXPECT_EQ(spacing("spacings: 0.488281 0.48828125 0.488281\n"), 0.488281);
  EXPECT_EQ(error(header("spacings: 0.5 0.5 1.5\n") + kVoxels),
            "spacings = 0.5 x 0.5 x 1.5: the voxels are no cubes; resample the volume to one spacing first");
  EXPECT_EQ(error(header("spacings: NaN NaN NaN\n") + kVoxels),
            "spacings = nan x nan x nan: must be positive and finite");
  EXPECT_EQ(error(header("spacings: 1 1 inf\n") + kVoxels),
            "spacings = 1 x 1 x inf: must be positive and finite");
  EXPECT_EQ(error(header("spacings: 1 1 -1\n") + kVoxels),
            "spacings = 1 x 1 x -1: must be positive and finite");
  EXPECT_EQ(error(header("spacings: 0 0 0\n") + kVoxels),
            "spacings = 0 x 0 x 0: must be positive and finite");
  EXPECT_EQ(error(header("spacings: 1 1\n") + kVoxels), "spacings = 1 1: must be three numbers");
  EXPECT_EQ(error(header("spacings: 1 1 1 1\n") + kVoxels), "spacings = 1 1 1 1: must be three numbers");
  EXPECT_EQ(error(header("space directions: (1,0,0) (1,1,0) (0,0,1)\n") + kVoxels),
            "space directions = (1,0,0) (1,1,0) ...: must be orthogonal");
  EXPECT_EQ(error(header("space directions: (nan,0,0) (0,1,0) (0,0,1)\n") + kVoxels),
            "space directions of length = nan x 1 x 1: must be positive and finite");
  EXPECT_EQ(error(header("space directions: (1,0,0) (0,1,0) none\n") + kVoxels),
            "space directions = (1,0,0) (0,1,0) ...: must be three vectors (x,y,z)");
}

TEST(Nrrd, HeadersAreChecked) {
  EXPECT_EQ(error("NRRD"), "not a NRRD file (NRRD0001 to NRRD0005)");
  EXPECT_EQ(error("NRRD0009\n\n"), "not a NRRD file (NRRD0001 to NRRD0005)");
  EXPECT_EQ(error("NRRD0004\ntype: uchar\n"), "truncated: ends within its header");
  EXPECT_EQ(error("NRRD0004\n\n"), "its header has no 'dimension'");
  EXPECT_EQ(error("NRRD0004\ndimension: 2\n\n"), "dimension = 2: must be 3");
  EXPECT_EQ(error(header("", "block") + kVoxels), "type = block: must be an integer type, float or double");
  EXPECT_EQ(error(header("", "uchar", "bzip2") + kVoxels), "encoding = bzip2: must be raw or gzip");
  EXPECT_EQ(error(header("", "short") + kVoxels + kVoxels), "its header has no 'endian'");
  EXPECT_EQ(error(header("endian: middle\n", "short") + kVoxels + kVoxels),
            "endian = middle: must be little or big");
  EXPECT_EQ(error(header("endean: big\n", "short") + kVoxels), "unknown field 'endean'");
  EXPECT_EQ(error(header("type: short\n") + kVoxels), "'type' is given twice");
  EXPECT_EQ(error(header("data file: other.raw\n")), "its data are in another file, which is not supported");
  EXPECT_EQ(error(header("byte skip: -1\n") + kVoxels), "byte skip = -1: must be 0");
  EXPECT_EQ(error(header("nonsense\n") + kVoxels), "header line 'nonsense' is no 'field: value'");
  EXPECT_EQ(error(header("my key:=any: value\nkinds: domain domain domain\ncontent: x\n") + kVoxels), "");
}

TEST(Nrrd, SizesAreChecked) {
  const auto sized = [](const std::string& sizes, const std::string& encoding = "raw") {
    return error("NRRD0001\ndimension: 3\ntype: double\nendian: little\nencoding: " + encoding +
                 "\nsizes: " + sizes + "\n\n" + kVoxels);
  };
  EXPECT_EQ(sized("1 3 1"), "");
  EXPECT_EQ(sized("1 2"), "sizes = 1 2: must be three integers");
  EXPECT_EQ(sized("1 2 3 4"), "sizes = 1 2 3 4: must be three integers");
  EXPECT_EQ(sized("1 2 0"), "size in z = 0: must be in [1, 536870912]");
  EXPECT_EQ(sized("1 -2 3"), "size in y = -2: must be in [1, 536870912]");
  EXPECT_EQ(sized("5000 5000 5000"),
            "truncated: its 5000 x 5000 x 5000 voxels of float64 need 1000000000000 bytes, and it holds no "
            "more than 24");
  EXPECT_NE(sized("536870912 536870912 64").find("truncated"), std::string::npos);
  EXPECT_NE(sized("5000 5000 5000", "gzip").find("truncated"), std::string::npos);
}

TEST(Nrrd, EveryTruncationIsFound) {
  for (const std::string& file : {header("spacings: 1 1 1\n") + kVoxels,
                                  header("", "uchar", "gzip") + deflated(kVoxels, Deflate::gzip)}) {
    EXPECT_EQ(error(file), "");
    for (std::size_t size = 0; size < file.size(); ++size) EXPECT_NE(error(file.substr(0, size)), "") << size;
  }
}

}  // namespace
}  // namespace gridstep
