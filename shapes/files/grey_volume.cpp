#include "shapes/files/grey_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "shapes/files/inflate.hpp"

namespace gridstep {

namespace {

constexpr std::int64_t kLargestSide = 1 << 29;

/// Whether a whole number is in the range of an integer type: 2^digits is a double, and the largest value need
/// not be one.
template <class Integer>
bool in_range(double whole) {
  return whole >= double(std::numeric_limits<Integer>::min()) &&
         whole < std::ldexp(1.0, std::numeric_limits<Integer>::digits);
}

/// low <= value <= high, in the type of the values.
template <class T>
struct Within {
  T low{}, high{};
  bool none = false;

  explicit Within(const GreyRange& range) {
    if constexpr (std::is_floating_point_v<T>) {
      // A float that compares alike with the bound itself: rounded towards the inside.
      low = T(range.low);
      high = T(range.high);
      if (double(low) < range.low) low = std::nextafter(low, std::numeric_limits<T>::infinity());
      if (double(high) > range.high) high = std::nextafter(high, -std::numeric_limits<T>::infinity());
    } else {
      const double first = std::ceil(range.low), last = std::floor(range.high);
      constexpr T least = std::numeric_limits<T>::min(), most = std::numeric_limits<T>::max();
      none = first > last || (first > 0 && !in_range<T>(first)) || (last < 0 && !in_range<T>(last));
      low = in_range<T>(first) ? T(first) : least;
      high = in_range<T>(last) ? T(last) : most;
    }
  }
  bool operator()(T value) const { return !none && low <= value && value <= high; }
};

template <class From, class To>
bool holds(From value) {
  constexpr bool from_real = std::is_floating_point_v<From>, to_real = std::is_floating_point_v<To>;
  if constexpr (!from_real && !to_real)
    return std::in_range<To>(value);
  else if constexpr (!to_real)
    return value == std::trunc(value) && in_range<To>(double(value));
  else if constexpr (!from_real)
    return in_range<From>(double(To(value))) && From(To(value)) == value;
  else
    return std::isnan(value) || From(To(value)) == value;
}

/// +value: a char type is a number.
template <class T>
std::string text_of(T value) {
  return fmt::format("{}", +value);
}

}  // namespace

std::size_t bytes_of(VoxelType type) {
  return with_type(type, []<class T>(T) { return sizeof(T); });
}

std::string_view name_of(VoxelType type) {
  constexpr std::string_view names[] = {"uint8", "int8",   "uint16", "int16",   "uint32",
                                        "int32", "uint64", "int64",  "float32", "float64"};
  return names[std::size_t(type)];
}

DigitalSet<3> threshold(const GreyVolume& volume, const GreyRange& range) {
  const LatticeBox<3> box{LatticePoint<3>::Zero(), volume.extent.array() - 1};
  DigitalSet<3> set(box);
  bool empty = true;
  with_type(volume.type, [&]<class T>(T) {
    const Within<T> within(range);
    for_each_point(LatticeBox<3>{Brick<3>::of(box.lo), Brick<3>::of(box.hi)}, [&](const LatticePoint<3>& b) {
      const LatticePoint<3> origin = Brick<3>::origin(b);
      const LatticeBox<3> cells = box.intersection({origin, origin.array() + (Brick<3>::extent(0) - 1)});
      Brick<3> bits;
      for_each_point(cells, [&](const LatticePoint<3>& z) {
        if (within(volume.value<T>(volume.index(z)))) bits.set(Brick<3>::bit(z), true);
      });
      if (bits == Brick<3>{}) return;
      set.set_brick(b, bits);
      empty = false;
    });
  });
  if (empty) throw InputError(fmt::format("{}: no voxel in [{}, {}]", volume.name, range.low, range.high));
  return set;
}

GreyRange foreground(const GreyVolume& volume) {
  return with_type(volume.type, [&]<class T>(T) {
    T least = volume.value<T>(0), most = least, other{};
    bool two = true;
    for (std::size_t i = 0, n = volume.voxels(); i < n; ++i) {
      const T value = volume.value<T>(i);
      least = std::min(least, value);
      most = std::max(most, value);
      if (value == T{}) continue;
      if (other == T{}) other = value;
      two &= value == other;
    }
    // Where there is nothing but 0, the foreground is empty, and threshold() says so.
    if (two) return other == T{} ? GreyRange{1, 1} : GreyRange{double(other), double(other)};
    throw InputError(
        fmt::format("{}: a grey volume, with values from {} to {}; --threshold LOW,HIGH says which are the "
                    "foreground",
                    volume.name, text_of(least), text_of(most)));
  });
}

GreyVolume binary(const GreyVolume& volume, const GreyRange& range) {
  GreyVolume result{volume.name, volume.extent, volume.spacing, VoxelType::uint8, {}};
  result.bytes.resize(volume.voxels());
  with_type(volume.type, [&]<class T>(T) {
    const Within<T> within(range);
    for (std::size_t i = 0; i < result.bytes.size(); ++i) result.bytes[i] = within(volume.value<T>(i));
  });
  return result;
}

GreyVolume as_type(const GreyVolume& volume, VoxelType type) {
  if (type == volume.type) return volume;
  GreyVolume result{volume.name, volume.extent, volume.spacing, type, {}};
  result.bytes.resize(volume.voxels() * bytes_of(type));
  with_type(volume.type, [&]<class From>(From) {
    with_type(type, [&]<class To>(To) {
      for (std::size_t i = 0, n = volume.voxels(); i < n; ++i) {
        const From value = volume.value<From>(i);
        if (!holds<From, To>(value))
          throw InputError(
              fmt::format("{}: the value {} does not fit {}; --threshold LOW,HIGH makes it 0 and 1",
                          volume.name, text_of(value), name_of(type)));
        const To converted = To(value);
        std::memcpy(result.bytes.data() + i * sizeof(To), &converted, sizeof(To));
      }
    });
  });
  return result;
}

GreyVolume volume_of_size(const ByteReader& file, const std::array<std::int64_t, 3>& sides, VoxelType type) {
  GreyVolume volume;
  volume.name = file.name();
  volume.type = type;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t side = sides[std::size_t(axis)];
    if (side < 1 || side > kLargestSide)
      file.fail(fmt::format("size in {} = {}: must be in [1, {}]", "xyz"[axis], side, kLargestSide));
    volume.extent[axis] = int(side);
  }
  return volume;
}

std::array<std::int64_t, 3> sides_in(const ByteReader& file, std::string_view what, std::string_view text) {
  std::string words(text);
  std::replace(words.begin(), words.end(), ',', ' ');
  std::array<std::int64_t, 3> sides;
  std::string_view rest = words;
  for (std::int64_t& side : sides) {
    const auto number = number_in<std::int64_t>(next_word(rest));
    if (!number) file.fail(fmt::format("{} = {}: must be three integers", what, shown(text)));
    side = *number;
  }
  if (!trimmed(rest).empty()) file.fail(fmt::format("{} = {}: must be three integers", what, shown(text)));
  return sides;
}

std::size_t needed_bytes(const ByteReader& file, const GreyVolume& volume, std::size_t most) {
  // In doubles there is no overflow, and where they round, it is far too much.
  const LatticePoint<3>& n = volume.extent;
  const double needed = double(n[0]) * double(n[1]) * double(n[2]) * double(bytes_of(volume.type));
  if (needed > double(most))
    file.fail(fmt::format(
        "truncated: its {} x {} x {} voxels of {} need {:.0f} bytes, and it holds no more than {}", n[0],
        n[1], n[2], name_of(volume.type), needed, most));
  return volume.voxels() * bytes_of(volume.type);
}

void put_in_order(std::string& bytes, std::size_t bytes_each, std::endian order) {
  if (order == std::endian::native || bytes_each == 1) return;
  for (auto value = bytes.begin(); value != bytes.end(); value += std::ptrdiff_t(bytes_each))
    std::reverse(value, value + std::ptrdiff_t(bytes_each));
}

void read_raw_voxels(ByteReader& file, GreyVolume& volume, std::endian order) {
  volume.bytes = file.take(needed_bytes(file, volume, file.left()));
  put_in_order(volume.bytes, bytes_of(volume.type), order);
}

void read_deflated_voxels(ByteReader& file, GreyVolume& volume, std::endian order) {
  Inflater stream(file);
  volume.bytes = stream.take(needed_bytes(file, volume, stream.most()));
  stream.expect_end();
  put_in_order(volume.bytes, bytes_of(volume.type), order);
}

double isotropic_spacing(const ByteReader& file, std::string_view what,
                         const std::array<double, 3>& spacings) {
  const auto [least, most] = std::minmax_element(spacings.begin(), spacings.end());
  const std::string text =
      fmt::format("{} = {:.6g} x {:.6g} x {:.6g}", what, spacings[0], spacings[1], spacings[2]);
  for (const double spacing : spacings)
    if (!(spacing > 0 && std::isfinite(spacing))) file.fail(text + ": must be positive and finite");
  if (*most - *least > 1e-4 * *most)
    file.fail(text + ": the voxels are no cubes; resample the volume to one spacing first");
  return spacings[0];
}

}  // namespace gridstep
