#include "experiments/program/surfel_csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "estimators/contour/digital_contour.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

template <int d>
void write_surfel_csv(OutputFile& file, std::span<const Surfel<d>> surfels, GridStep h, bool pointels,
                      std::span<const std::size_t> component_begin,
                      const std::vector<SurfelColumn>& columns) {
  fmt::memory_buffer line;
  const auto out = std::back_inserter(line);
  const auto end_line = [&] {
    line.data()[line.size() - 1] = '\n';
    file.write({line.data(), line.size()});
    line.clear();
  };
  for (int k = 0; k < d; ++k) fmt::format_to(out, "k{},", "xyz"[k]);
  if (pointels) fmt::format_to(out, "px,py,");
  for (int k = 0; k < d; ++k) fmt::format_to(out, "{},", "xyz"[k]);
  if (!component_begin.empty()) fmt::format_to(out, "component,");
  for (const SurfelColumn& column : columns) fmt::format_to(out, "{},", column.title);
  end_line();
  std::size_t component = 0;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    const Cell<d> cell = surfels[i].cell();
    for (int k = 0; k < d; ++k) fmt::format_to(out, "{},", cell.coordinates[k]);
    if constexpr (d == 2)
      if (pointels) {
        const LatticePoint<2> p = pointel<2>(start_pointel(surfels[i])).coordinates;
        fmt::format_to(out, "{},{},", p[0], p[1]);
      }
    const RealPoint<d> position = centre(cell, h.value);
    for (int k = 0; k < d; ++k) fmt::format_to(out, "{},", position[k]);
    if (!component_begin.empty()) {
      while (component_begin[component + 1] <= i) ++component;
      fmt::format_to(out, "{},", component);
    }
    for (const SurfelColumn& column : columns)
      !column.known || (*column.known)[i] ? fmt::format_to(out, "{},", (*column.values)[i])
                                          : fmt::format_to(out, ",");
    end_line();
  }
}

template void write_surfel_csv(OutputFile&, std::span<const Surfel<2>>, GridStep, bool,
                               std::span<const std::size_t>, const std::vector<SurfelColumn>&);
template void write_surfel_csv(OutputFile&, std::span<const Surfel<3>>, GridStep, bool,
                               std::span<const std::size_t>, const std::vector<SurfelColumn>&);

}  // namespace gridstep
