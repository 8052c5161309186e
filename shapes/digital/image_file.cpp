#include "shapes/digital/image_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace gridstep {

namespace {

constexpr int kLargestSide = 1 << 29;  // Khalimsky coordinates, twice as large, are ints

std::string read_all(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw InputError(path + ": not found");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  // Inserting an empty buffer would set the same flag as a failure does.
  if (file.is_open() && !std::filesystem::is_directory(path, ignored) &&
      file.peek() != std::ifstream::traits_type::eof())
    content << file.rdbuf();
  else if (!file.eof())
    throw InputError(path + ": cannot be read");
  if (!content) throw InputError(path + ": cannot be read");
  return std::move(content).str();
}

/// Goes once through a file, from front to back.
class PnmReader {
 public:
  explicit PnmReader(const std::string& path) : path_(path), bytes_(read_all(path)) {}

  GreyImage read() {
    const std::string_view format = bytes_.starts_with('P') ? word() : "";
    const bool grey = format == "P2" || format == "P5";
    if (!grey && format != "P1" && format != "P4") fail("not a PGM or PBM image (P1, P2, P4 or P5)");
    image_.name = path_;
    image_.width = header_number("width", kLargestSide);
    image_.height = header_number("height", kLargestSide);
    if (grey) maximum_ = header_number("maximum value", 65535);
    if (format == "P1")
      read_bit_characters();
    else if (format == "P2")
      read_decimals();
    else {
      // One white-space character, or a comment with its line end, stands between the header and the bytes.
      if (at_ < bytes_.size() && bytes_[at_] == '#')
        skip_comment();
      else
        at_ = std::min(at_ + 1, bytes_.size());
      if (format == "P4")
        read_bits();
      else
        read_binary_values();
    }
    return std::move(image_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(path_ + ": " + what); }

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

  /// Up to white space or a comment; empty at the end of the file.
  std::string_view word() {
    skip_space();
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !is_space(bytes_[at_]) && bytes_[at_] != '#') ++at_;
    return std::string_view(bytes_).substr(begin, at_ - begin);
  }

  /// Of a decimal number; -1 for anything else, and above 9 digits.
  static int value_of(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of('0'), text.size() - 1));
    if (text.size() > 9) return -1;
    int value = 0;
    for (const char digit : text) {
      if (digit < '0' || digit > '9') return -1;
      value = 10 * value + (digit - '0');
    }
    return value;
  }

  /// For messages: one line, whatever the file holds.
  static std::string shown(std::string_view text) {
    std::string result;
    for (const char c : text.substr(0, 16)) result += c > ' ' && c < '\x7f' ? c : '?';
    return result + (text.size() > 16 ? "..." : "");
  }

  int header_number(const char* what, int largest) {
    const std::string_view text = word();
    if (text.empty()) fail(fmt::format("truncated: no {}", what));
    const int value = value_of(text);
    if (value < 1 || value > largest)
      fail(fmt::format("{} = {}: must be an integer in [1, {}]", what, shown(text), largest));
    return value;
  }

  std::size_t width() const { return std::size_t(image_.width); }

  [[noreturn]] void fail_truncated() const {
    fail(fmt::format("truncated: ends before its {} x {} pixels do", image_.width, image_.height));
  }

  /// Before memory is taken: the size in a header may be anything.
  void expect_bytes(std::size_t least) {
    if (bytes_.size() - at_ < least) fail_truncated();
    image_.values.reserve(pixels());
  }

  std::size_t pixels() const { return width() * std::size_t(image_.height); }

  void append(int value, std::string_view text) {
    const std::size_t i = image_.values.size();
    if (value < 0 || value > maximum_)
      fail(fmt::format("pixel {} of row {} = {}: must be an integer in [0, {}]", i % width(), i / width(),
                       shown(text), maximum_));
    image_.values.push_back(std::uint16_t(value));
  }

  void read_bit_characters() {
    expect_bytes(pixels());
    while (image_.values.size() < pixels()) {
      skip_space();  // which is optional here
      if (at_ == bytes_.size()) fail_truncated();
      append(bytes_[at_] - '0', std::string_view(bytes_).substr(at_, 1));
      ++at_;
    }
  }

  void read_decimals() {
    expect_bytes(2 * pixels());  // each has a digit and white space before it
    while (image_.values.size() < pixels()) {
      const std::string_view text = word();
      if (text.empty()) fail_truncated();
      append(value_of(text), text);
    }
  }

  int next_byte() { return static_cast<unsigned char>(bytes_[at_++]); }

  /// Rows of whole bytes, the leftmost pixel in the highest bit.
  void read_bits() {
    const std::size_t row_bytes = (width() + 7) / 8;
    expect_bytes(row_bytes * std::size_t(image_.height));
    for (int row = 0; row < image_.height; ++row)
      for (std::size_t b = 0; b < row_bytes; ++b) {
        const int byte = next_byte();
        for (std::size_t x = 8 * b; x < std::min(8 * b + 8, width()); ++x)
          image_.values.push_back(std::uint16_t(byte >> (7 - x % 8) & 1));
      }
  }

  void read_binary_values() {
    const std::size_t value_bytes = maximum_ > 255 ? 2 : 1;
    expect_bytes(value_bytes * pixels());
    while (image_.values.size() < pixels()) {
      int value = next_byte();
      if (value_bytes == 2) value = 256 * value + next_byte();
      append(value, std::to_string(value));
    }
  }

  std::string path_, bytes_;
  std::size_t at_ = 0;
  int maximum_ = 1;
  GreyImage image_;
};

}  // namespace

GreyImage read_image(const std::string& path) {
  return PnmReader(path).read();
}

DigitalSet<2> threshold(const GreyImage& image, int low, int high) {
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
