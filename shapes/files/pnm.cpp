#include "shapes/files/pnm.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

constexpr int kLargestSide = 1 << 29;  // Khalimsky coordinates, twice as large, are ints

/// Goes once through a file, from front to back.
class PnmReader {
 public:
  PnmReader(ByteReader& file, std::span<const std::string_view> side_names)
      : file_(file), bytes_(file.rest()), side_names_(side_names) {}

  PnmGrid read(std::span<const PnmMagic> magics, std::string_view what) {
    const std::string_view format = bytes_.starts_with('P') ? word() : "";
    const auto magic =
        std::find_if(magics.begin(), magics.end(), [&](const PnmMagic& m) { return m.word == format; });
    if (magic == magics.end()) fail(fmt::format("not a {}", what));
    const PnmEncoding encoding = magic->encoding;
    for (const std::string_view name : side_names_) grid_.sides.push_back(header_number(name, kLargestSide));
    if (encoding == PnmEncoding::decimals || encoding == PnmEncoding::bytes)
      grid_.maximum = header_number("maximum value", 65535);
    switch (encoding) {
      case PnmEncoding::bit_characters:
        read_bit_characters();
        break;
      case PnmEncoding::decimals:
        read_decimals();
        break;
      case PnmEncoding::bits:
        skip_header_end();
        read_bits();
        break;
      case PnmEncoding::bytes:
        skip_header_end();
        read_bytes();
        break;
    }
    return std::move(grid_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { file_.fail(what); }

  static bool is_space(char c) { return std::string_view(" \t\n\v\f\r").find(c) != std::string_view::npos; }

  void skip_comment() { at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1) + 1; }

  void skip_space() {
    for (; at_ < bytes_.size(); ++at_)
      if (bytes_[at_] == '#') {
        skip_comment();
        --at_;
      } else if (!is_space(bytes_[at_])) {
        return;
      }
  }

  /// One white-space character, or a comment with its line end, stands between the header and the bytes.
  void skip_header_end() {
    if (at_ < bytes_.size() && bytes_[at_] == '#')
      skip_comment();
    else
      at_ = std::min(at_ + 1, bytes_.size());
  }

  /// Up to white space or a comment; empty at the end of the file.
  std::string_view word() {
    skip_space();
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !is_space(bytes_[at_]) && bytes_[at_] != '#') ++at_;
    return bytes_.substr(begin, at_ - begin);
  }

  /// Of a decimal number; -1 for anything else, and above 9 digits.
  static int value_of(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of('0'), text.size() - 1));
    if (text.size() > 9 || text.starts_with('-')) return -1;
    return number_in<int>(text).value_or(-1);
  }

  int header_number(std::string_view what, int largest) {
    const std::string_view text = word();
    if (text.empty()) fail(fmt::format("truncated: no {}", what));
    const int value = value_of(text);
    if (value < 1 || value > largest)
      fail(fmt::format("{} = {}: must be an integer in [1, {}]", what, shown(text), largest));
    return value;
  }

  std::size_t width() const { return std::size_t(grid_.sides.front()); }
  const char* element() const { return side_names_.size() == 2 ? "pixel" : "voxel"; }

  [[noreturn]] void fail_truncated() const {
    fail(fmt::format("truncated: ends before its {} {}s do", fmt::join(grid_.sides, " x "), element()));
  }

  /// The number of values, where at least `least_bits` of the rest of the file belong to each. Memory is taken only
  /// after this: the sides in a header may be anything.
  std::size_t count(std::size_t least_bits) {
    const std::size_t most = 8 * (bytes_.size() - at_) / least_bits;
    std::size_t result = 1;
    for (const int side : grid_.sides) {
      if (std::size_t(side) > most / result) fail_truncated();
      result *= std::size_t(side);
    }
    grid_.values.reserve(result);
    return result;
  }

  void append(int value, std::string_view text) {
    const std::size_t i = grid_.values.size();
    if (value < 0 || value > grid_.maximum)
      fail(fmt::format("{} {} of row {} = {}: must be an integer in [0, {}]", element(), i % width(),
                       i / width(), shown(text), grid_.maximum));
    grid_.values.push_back(std::uint16_t(value));
  }

  void read_bit_characters() {
    const std::size_t size = count(8);
    while (grid_.values.size() < size) {
      skip_space();  // which is optional here
      if (at_ == bytes_.size()) fail_truncated();
      append(bytes_[at_] - '0', bytes_.substr(at_, 1));
      ++at_;
    }
  }

  void read_decimals() {
    const std::size_t size = count(16);  // each has a digit and white space before it
    while (grid_.values.size() < size) {
      const std::string_view text = word();
      if (text.empty()) fail_truncated();
      append(value_of(text), text);
    }
  }

  int next_byte() { return static_cast<unsigned char>(bytes_[at_++]); }

  /// Rows of whole bytes, the leftmost value in the highest bit.
  void read_bits() {
    const std::size_t rows = count(1) / width();
    const std::size_t row_bytes = (width() + 7) / 8;
    if (rows > (bytes_.size() - at_) / row_bytes) fail_truncated();
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t b = 0; b < row_bytes; ++b) {
        const int byte = next_byte();
        for (std::size_t x = 8 * b; x < std::min(8 * b + 8, width()); ++x)
          grid_.values.push_back(std::uint16_t(byte >> (7 - x % 8) & 1));
      }
  }

  void read_bytes() {
    const std::size_t value_bytes = grid_.maximum > 255 ? 2 : 1;
    const std::size_t size = count(8 * value_bytes);
    while (grid_.values.size() < size) {
      int value = next_byte();
      if (value_bytes == 2) value = 256 * value + next_byte();
      append(value, std::to_string(value));
    }
  }

  ByteReader& file_;
  std::string_view bytes_;
  std::span<const std::string_view> side_names_;
  std::size_t at_ = 0;
  PnmGrid grid_;
};

}  // namespace

PnmGrid read_pnm(ByteReader& file, std::span<const PnmMagic> magics,
                 std::span<const std::string_view> side_names, std::string_view what) {
  return PnmReader(file, side_names).read(magics, what);
}

}  // namespace gridstep
