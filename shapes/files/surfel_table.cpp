#include "shapes/files/surfel_table.hpp"

namespace gridstep {

template <int d>
std::vector<SurfelColumn> cell_columns(std::span<const Surfel<d>> surfels) {
  std::vector<SurfelColumn> columns;
  for (int k = 0; k < d; ++k)
    columns.push_back({std::string("k") + "xyz"[k], SurfelColumn::Type::integer,
                       [surfels, k](std::size_t i) { return surfels[i].cell().coordinates[k]; }});
  return columns;
}

template <int d>
std::vector<SurfelColumn> centre_columns(std::span<const Surfel<d>> surfels, GridStep h) {
  std::vector<SurfelColumn> columns;
  for (int k = 0; k < d; ++k)
    columns.push_back({std::string(1, "xyz"[k]), SurfelColumn::Type::real,
                       [surfels, k, h](std::size_t i) { return centre(surfels[i], h.value)[k]; }});
  return columns;
}

template std::vector<SurfelColumn> cell_columns(std::span<const Surfel<2>>);
template std::vector<SurfelColumn> cell_columns(std::span<const Surfel<3>>);
template std::vector<SurfelColumn> centre_columns(std::span<const Surfel<2>>, GridStep);
template std::vector<SurfelColumn> centre_columns(std::span<const Surfel<3>>, GridStep);

}  // namespace gridstep
