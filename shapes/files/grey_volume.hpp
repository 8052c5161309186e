#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shapes/base/contracts.hpp"
#include "shapes/digital/digital_set.hpp"
#include "shapes/files/byte_reader.hpp"

namespace gridstep {

enum class VoxelType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

/// Calls visit(T{}) for the arithmetic type T of the voxels, and returns what it returns.
template <class Visit>
decltype(auto) with_type(VoxelType type, Visit visit) {
  switch (type) {
    case VoxelType::uint8:
      return visit(std::uint8_t{});
    case VoxelType::int8:
      return visit(std::int8_t{});
    case VoxelType::uint16:
      return visit(std::uint16_t{});
    case VoxelType::int16:
      return visit(std::int16_t{});
    case VoxelType::uint32:
      return visit(std::uint32_t{});
    case VoxelType::int32:
      return visit(std::int32_t{});
    case VoxelType::uint64:
      return visit(std::uint64_t{});
    case VoxelType::int64:
      return visit(std::int64_t{});
    case VoxelType::float32:
      return visit(float{});
    case VoxelType::float64:
      break;
  }
  return visit(double{});
}

std::size_t bytes_of(VoxelType type);
/// uint8, int16, float32, ...: also the names that --type takes.
std::string_view name_of(VoxelType type);
inline constexpr std::array kVoxelTypes{
    VoxelType::uint8, VoxelType::int8,   VoxelType::uint16, VoxelType::int16,   VoxelType::uint32,
    VoxelType::int32, VoxelType::uint64, VoxelType::int64,  VoxelType::float32, VoxelType::float64};

/// A volume of grey values on a cubic lattice.
struct GreyVolume {
  std::string name;                 ///< what errors call it
  LatticePoint<3> extent{0, 0, 0};  ///< the voxels are the points from 0 to extent - 1
  double spacing = 1;               ///< edge of a voxel in the unit of the file; 1 where it has none
  VoxelType type = VoxelType::uint8;
  std::string bytes;  ///< of all values in the processor's order; x counts first, then y, then z

  std::size_t voxels() const {
    return std::size_t(extent[0]) * std::size_t(extent[1]) * std::size_t(extent[2]);
  }
  std::size_t index(const LatticePoint<3>& z) const {
    return std::size_t(z[0]) +
           std::size_t(extent[0]) * (std::size_t(z[1]) + std::size_t(extent[1]) * std::size_t(z[2]));
  }
  /// The value of the i-th voxel in its own type, which is that of the volume.
  template <class T>
  T value(std::size_t i) const {
    T result;
    std::memcpy(&result, bytes.data() + i * sizeof(T), sizeof(T));
    return result;
  }
  /// The value at a point, as far as a double holds it.
  double at(const LatticePoint<3>& z) const {
    return with_type(type, [&]<class T>(T) { return double(value<T>(index(z))); });
  }
};

/// The grey values that are the foreground, both bounds included.
struct GreyRange {
  double low, high;
};

/// The voxels in a range. Outside of the volume is background: foreground that touches its border has its
/// boundary there. Bounds are compared exactly, also with 64-bit integers; a NaN is in no range. Cost O(voxels).
/// @throws InputError where there is no such voxel.
DigitalSet<3> threshold(const GreyVolume& volume, const GreyRange& range);

/// The range from the only other value than 0 to itself: of a volume that was segmented already.
/// @throws InputError, with the range of its values, for any other volume.
GreyRange foreground(const GreyVolume& volume);

/// 1 in the range, 0 outside.
GreyVolume binary(const GreyVolume& volume, const GreyRange& range);

/// The same values in another type. @throws InputError naming the first value that it does not hold exactly.
GreyVolume as_type(const GreyVolume& volume, VoxelType type);

/// Takes the three sides that a file claims; its `bytes` are still to be read.
/// @throws InputError unless they are in [1, 2^29], so that Khalimsky coordinates are ints.
GreyVolume volume_of_size(const ByteReader& file, const std::array<std::int64_t, 3>& sides, VoxelType type);

/// The sides in a text, "10 20 30" or "10,20,30". @throws InputError naming `what` and the text.
std::array<std::int64_t, 3> sides_in(const ByteReader& file, std::string_view what, std::string_view text);

/// Bytes of all voxels. @throws InputError where more than `most` are needed: nothing is allocated that the file
/// cannot fill.
std::size_t needed_bytes(const ByteReader& file, const GreyVolume& volume, std::size_t most);

/// Fills the volume with the next bytes of the file, which are in this order.
void read_raw_voxels(ByteReader& file, GreyVolume& volume, std::endian order);
/// The same with what follows in a zlib or gzip stream, which has to end with the last voxel.
void read_deflated_voxels(ByteReader& file, GreyVolume& volume, std::endian order);

/// From this order to the processor's.
void put_in_order(std::string& bytes, std::size_t bytes_each, std::endian order);

/// One spacing for all three directions, to within 1e-4 of it: rounding to a header's precision.
/// @throws InputError where they differ (a digital ball would be none), or are not positive and finite.
double isotropic_spacing(const ByteReader& file, std::string_view what,
                         const std::array<double, 3>& spacings);

/// Where a writer puts what it makes, piece by piece.
using Sink = std::function<void(std::string_view)>;

}  // namespace gridstep
