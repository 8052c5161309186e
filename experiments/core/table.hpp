#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace gridstep {

enum class Align { left, right };

struct Column {
  std::string title;
  Align align = Align::right;
};

/// Rows of formatted cells, one a column. Every rendering @throws ContractViolation if a row has another
/// length.
struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
};

/// For a person: aligned, UTF-8, title and rule above. A table that is wider than `width` becomes one block a row, with
/// a line a cell.
std::string to_text(const Table& table, std::size_t width = std::numeric_limits<std::size_t>::max());

/// A line of column titles, then the rows, quoted as in RFC 4180 but with "\n" at the ends of lines. No table
/// title.
std::string to_csv(const Table& table);

/// A LaTeX table for the package booktabs, the title as its caption. Text is escaped; common mathematical
/// symbols become commands, as LaTeX has no glyph for them in text.
std::string to_latex(const Table& table);

}  // namespace gridstep
