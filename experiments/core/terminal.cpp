#include "experiments/core/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "experiments/core/text.hpp"

namespace gridstep {

namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// One line without its end.
std::string fold_line(std::string_view line, std::size_t width) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  std::string result, ahead;
  while (display_width(ahead) + display_width(line) > width) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string_view::npos) break;
    const std::size_t room = width > ahead.size() ? width - ahead.size() : 0;
    std::size_t end = line.rfind(' ', cut_to_width(line, room).size());
    if (end == std::string_view::npos || end <= first) end = line.find(' ', first);
    if (end == std::string_view::npos) break;
    const std::string_view head = line.substr(0, line.find_last_not_of(' ', end) + 1);
    result.append(ahead).append(head).append("\n");
    line.remove_prefix(std::min(line.find_first_not_of(' ', end), line.size()));
    ahead.assign(std::min(indent + 2, width / 2), ' ');
    if (line.empty()) return result.substr(0, result.size() - 1);
  }
  return result.append(ahead).append(line);
}

}  // namespace

std::optional<std::size_t> line_width(std::FILE* stream) {
  winsize size{};
  if (::isatty(::fileno(stream)) != 1) return std::nullopt;
  const bool known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return (known ? size.ws_col : 80u) - 1u;
}

bool can_redraw(std::FILE* stream) {
  return ::isatty(::fileno(stream)) == 1 && environment("TERM") != "dumb" && environment("NO_COLOR").empty();
}

std::string fold(std::string_view text, std::size_t width) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result += fold_line(text.substr(0, end), width);
    if (end < text.size()) result += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace gridstep
