#include <fmt/format.h>

#include <cstdint>

#include "shapes/files/surface_file.hpp"

namespace gridstep {

namespace {

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

void write_npy(const SurfelTable& table, const Sink& sink) {
  std::vector<const SurfelColumn*> columns;
  for (const auto* group : {&table.keys, &table.values})
    for (const SurfelColumn& column : *group) columns.push_back(&column);
  const char order = std::endian::native == std::endian::little ? '<' : '>';
  std::string fields;
  for (const SurfelColumn* column : columns)
    fields += fmt::format("('{}', '{}{}'), ", column->title, order,
                          column->type == SurfelColumn::Type::integer ? "i4" : "f8");
  std::string header =
      fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", fields, table.rows);
  // Version 2 of the format: its header may be longer than 65535 bytes. The data begin at a multiple of 64.
  constexpr std::size_t before = 12, alignment = 64;
  header.append(alignment - (before + header.size() + 1) % alignment, ' ');
  header += '\n';
  std::string prefix("\x93NUMPY\x02\x00", 8);
  for (int byte = 0; byte < 4; ++byte) prefix += char(header.size() >> (8 * byte) & 0xff);
  sink(prefix + header);

  std::string record;
  for (std::size_t i = 0; i < table.rows; ++i) {
    record.clear();
    for (const SurfelColumn* column : columns) {
      const double value = column->value(i);
      if (column->type == SurfelColumn::Type::integer)
        append(record, std::int32_t(value));
      else
        append(record, value);
    }
    sink(record);
  }
}

}  // namespace gridstep
