#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/core/output_file.hpp"
#include "shapes/base/units.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// A column with one value a surfel.
struct SurfelColumn {
  std::string title;
  const std::vector<double>* values;
  const std::vector<std::uint8_t>* known = nullptr;  ///< where given, an empty field for 0
};

/// A surface as rows: a header, then one row a surfel with its Khalimsky coordinates kx,ky[,kz], its centre
/// x,y[,z], and the columns. In 2D with `pointels`, also px,py: the pointel at which the linel starts. With
/// components (DigitalSurface::component_begin), also the number of the component.
template <int d>
void write_surfel_csv(OutputFile& file, std::span<const Surfel<d>> surfels, GridStep h, bool pointels,
                      std::span<const std::size_t> component_begin, const std::vector<SurfelColumn>& columns);

}  // namespace gridstep
