#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "shapes/files/surface_file.hpp"

namespace gridstep {

void write_csv(const SurfelTable& table, const Sink& sink) {
  std::vector<const SurfelColumn*> columns;
  for (const auto* group : {&table.keys, &table.values})
    for (const SurfelColumn& column : *group) columns.push_back(&column);
  fmt::memory_buffer line;
  const auto out = std::back_inserter(line);
  const auto end_line = [&] {
    line.data()[line.size() - 1] = '\n';
    sink({line.data(), line.size()});
    line.clear();
  };
  for (const SurfelColumn* column : columns) fmt::format_to(out, "{},", column->title);
  end_line();
  for (std::size_t i = 0; i < table.rows; ++i) {
    for (const SurfelColumn* column : columns) {
      const double value = column->value(i);
      if (!std::isnan(value)) fmt::format_to(out, "{}", value);
      line.push_back(',');
    }
    end_line();
  }
}

}  // namespace gridstep
