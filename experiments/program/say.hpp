#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "experiments/core/table.hpp"
#include "experiments/core/terminal.hpp"

namespace gridstep {

/// What a person reads: on a terminal, folded to its width.
inline void say_text(std::FILE* stream, const std::string& text) {
  const auto width = line_width(stream);
  fmt::print(stream, "{}", width ? fold(text, *width) : text);
}

/// The same of a sentence or a line, as fmt::print. Lines are put together in one call each.
template <class... T>
void say(std::FILE* stream, fmt::format_string<T...> format, T&&... values) {
  say_text(stream, fmt::format(format, std::forward<T>(values)...));
}

/// As wide as fits, else in blocks; with an empty line below.
inline void say_table(std::FILE* stream, const Table& table) {
  const auto width = line_width(stream);
  say_text(stream, (width ? to_text(table, *width) : to_text(table)) + "\n");
}

}  // namespace gridstep
