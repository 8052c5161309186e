#include "experiments/core/table.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

#include "experiments/core/text.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

void check(const Table& table) {
  for (const std::vector<std::string>& row : table.rows)
    expects(row.size() == table.columns.size(), "as many cells in a row as columns");
}

std::vector<std::string> titles(const Table& table) {
  std::vector<std::string> result;
  for (const Column& column : table.columns) result.push_back(column.title);
  return result;
}

std::string csv_cell(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string latex(std::string_view text) {
  static constexpr std::pair<std::string_view, std::string_view> replacements[] = {
      {"\\", "\\textbackslash{}"},
      {"~", "\\textasciitilde{}"},
      {"^", "\\textasciicircum{}"},
      {"&", "\\&"},
      {"%", "\\%"},
      {"$", "\\$"},
      {"#", "\\#"},
      {"_", "\\_"},
      {"{", "\\{"},
      {"}", "\\}"},
      {"<", "$<$"},
      {">", "$>$"},
      {"α", "$\\alpha$"},
      {"κ", "$\\kappa$"},
      {"π", "$\\pi$"},
      {"±", "$\\pm$"},
      {"×", "$\\times$"},
      {"·", "$\\cdot$"},
      {"≤", "$\\leq$"},
      {"≥", "$\\geq$"},
      {"≈", "$\\approx$"},
      {"∞", "$\\infty$"},
      {"√", "$\\surd$"},
      {"−", "$-$"},
      {"²", "$^2$"},
      {"³", "$^3$"}};
  std::string result;
  while (!text.empty()) {
    const auto* found = std::find_if(std::begin(replacements), std::end(replacements),
                                     [&](const auto& pair) { return text.starts_with(pair.first); });
    const bool plain = found == std::end(replacements);
    result += plain ? text.substr(0, 1) : found->second;
    text.remove_prefix(plain ? 1 : found->first.size());
  }
  return result;
}

/// `cells` with a separator between them and an end after the last.
template <class Format>
std::string join(const std::vector<std::string>& cells, std::string_view separator, std::string_view end,
                 Format format) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += separator;
    line += format(cells[i], i);
  }
  return line.append(end);
}

/// For a narrow terminal.
std::string blocks(const Table& table) {
  std::size_t title_width = 0;
  for (const Column& column : table.columns) title_width = std::max(title_width, display_width(column.title));
  std::string text = table.title.empty() ? "" : table.title + "\n";
  for (const std::vector<std::string>& row : table.rows) {
    if (!text.empty()) text += "\n";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string& title = table.columns[i].title;
      text += title + std::string(title_width - display_width(title) + 2, ' ') + row[i] + "\n";
    }
  }
  return text;
}

}  // namespace

std::string to_text(const Table& table, std::size_t width) {
  check(table);
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    widths.push_back(display_width(table.columns[i].title));
    for (const std::vector<std::string>& row : table.rows)
      widths[i] = std::max(widths[i], display_width(row[i]));
  }
  const std::size_t gaps = 2 * (std::max<std::size_t>(1, widths.size()) - 1);
  if (std::accumulate(widths.begin(), widths.end(), gaps) > width) return blocks(table);
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string result = join(cells, "  ", "", [&](const std::string& cell, std::size_t i) {
      const std::string padding(widths[i] - display_width(cell), ' ');
      return table.columns[i].align == Align::left ? cell + padding : padding + cell;
    });
    result.erase(result.find_last_not_of(' ') + 1);
    return result + "\n";
  };
  std::vector<std::string> rules;
  for (const std::size_t dashes : widths) rules.emplace_back(dashes, '-');

  std::string text = table.title.empty() ? "" : table.title + "\n";
  text += line(titles(table)) + line(rules);
  for (const std::vector<std::string>& row : table.rows) text += line(row);
  return text;
}

std::string to_csv(const Table& table) {
  check(table);
  const auto line = [](const std::vector<std::string>& cells) {
    return join(cells, ",", "\n", [](const std::string& cell, std::size_t) { return csv_cell(cell); });
  };
  std::string text = line(titles(table));
  for (const std::vector<std::string>& row : table.rows) text += line(row);
  return text;
}

std::string to_latex(const Table& table) {
  check(table);
  const auto line = [](const std::vector<std::string>& cells) {
    // A bracket that opens a row would be read as an option of the \\ or of the rule before it.
    return join(cells, " & ", " \\\\\n", [](const std::string& cell, std::size_t) {
      return (cell.starts_with('[') ? "{}" : "") + latex(cell);
    });
  };
  std::string text = "\\begin{table}\n\\centering\n";
  if (!table.title.empty()) text += "\\caption{" + latex(table.title) + "}\n";
  text += "\\begin{tabular}{";
  for (const Column& column : table.columns) text += column.align == Align::left ? 'l' : 'r';
  text += "}\n\\toprule\n" + line(titles(table)) + "\\midrule\n";
  for (const std::vector<std::string>& row : table.rows) text += line(row);
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

}  // namespace gridstep
