#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace gridstep {

/// Goes once through the content of a file, from front to back. A failure is an InputError in one line, "name:
/// what", whatever the file holds.
class ByteReader {
 public:
  ByteReader(std::string name, std::string bytes) : name_(std::move(name)), bytes_(std::move(bytes)) {}

  const std::string& name() const { return name_; }
  std::size_t left() const { return bytes_.size() - at_; }
  std::string_view rest() const { return std::string_view(bytes_).substr(at_); }

  /// The next `size` bytes, which are there.
  std::string_view take(std::size_t size);
  /// Up to the next line end, which is skipped, with CR LF as one; nothing where the content ends before.
  std::optional<std::string_view> line();

  [[noreturn]] void fail(std::string_view what) const;

 private:
  std::string name_, bytes_;
  std::size_t at_ = 0;
};

/// The content of a file or pipe. @throws InputError where it is not found or cannot be read.
ByteReader open_file(const std::string& path);

/// Of a file's text, for messages: one line of printable characters.
std::string shown(std::string_view text);

/// Without the white space around it.
std::string_view trimmed(std::string_view text);

/// The whole text as a number, without white space around it.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The next word of a text, which it is cut off from; empty where there is none.
std::string_view next_word(std::string_view& text);

}  // namespace gridstep
