#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// One number a surfel. NaN stands for no value: an empty field in CSV.
struct SurfelColumn {
  enum class Type { integer, real };
  std::string title;
  Type type;
  std::function<double(std::size_t surfel)> value;
};

/// What is known of each surfel of a digital boundary.
struct SurfelTable {
  std::size_t rows = 0;
  std::vector<SurfelColumn> keys;    ///< which surfel it is, and where: not in files that hold a mesh
  std::vector<SurfelColumn> values;  ///< what was estimated there
};

/// Khalimsky coordinates kx, ky[, kz]. The surfels have to outlive the columns.
template <int d>
std::vector<SurfelColumn> cell_columns(std::span<const Surfel<d>> surfels);

/// Centres x, y[, z]. The surfels have to outlive the columns.
template <int d>
std::vector<SurfelColumn> centre_columns(std::span<const Surfel<d>> surfels, GridStep h);

}  // namespace gridstep
