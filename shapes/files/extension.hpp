#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>

#include "shapes/base/contracts.hpp"

namespace gridstep {

/// The line of a table of formats, each with its `extension`, that a path ends with, in small or capital letters.
/// Lines for which `usable` is false are passed over. @throws InputError listing the extensions of the others.
template <class Table, class Usable>
const auto& format_of(const std::string& path, const Table& table, Usable usable) {
  std::string name = path, known;
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  for (const auto& format : table) {
    if (!usable(format)) continue;
    if (name.ends_with(format.extension)) return format;
    known += (known.empty() ? "" : ", ") + std::string(format.extension);
  }
  throw InputError(fmt::format("{}: its extension must be one of {}", path, known));
}

}  // namespace gridstep
