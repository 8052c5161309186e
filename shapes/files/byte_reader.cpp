#include "shapes/files/byte_reader.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

constexpr std::string_view kSpace = " \t\r\n\v\f";

}  // namespace

std::string_view ByteReader::take(std::size_t size) {
  expects(size <= left(), "no more bytes to take than there are");
  const std::string_view taken = rest().substr(0, size);
  at_ += size;
  return taken;
}

std::optional<std::string_view> ByteReader::line() {
  const std::size_t size = rest().find('\n');
  if (size == std::string_view::npos) return std::nullopt;
  std::string_view text = take(size + 1);
  text.remove_suffix(1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

void ByteReader::fail(std::string_view what) const {
  throw InputError(name_ + ": " + std::string(what));
}

ByteReader open_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) throw InputError(path + ": not found");
  // A device may be endless.
  if (fs::is_directory(status) || fs::is_character_file(status)) throw InputError(path + ": is not a file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  // Inserting an empty buffer would set the same flag as a failure does.
  if (file.is_open() && file.peek() != std::ifstream::traits_type::eof()) content << file.rdbuf();
  if (!file.is_open() || file.bad() || !content) throw InputError(path + ": cannot be read");
  return {path, std::move(content).str()};
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 16;
  std::string result;
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c < '\x7f' ? c : '?';
  return result + (text.size() > longest ? "..." : "");
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  return text.substr(0, text.find_last_not_of(kSpace) + 1);
}

std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kSpace));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace gridstep
