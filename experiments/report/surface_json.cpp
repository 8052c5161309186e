#include "experiments/report/surface_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "experiments/report/base64.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

using nlohmann::ordered_json;

namespace {

const std::array<std::string, 6> kDirections{"dir1_x", "dir1_y", "dir1_z", "dir2_x", "dir2_y", "dir2_z"};

bool has_directions(const Estimates& estimates) {
  return std::all_of(kDirections.begin(), kDirections.end(), [&](const std::string& name) {
    return std::find(estimates.quantities.begin(), estimates.quantities.end(), name) !=
           estimates.quantities.end();
  });
}

LatticePoint<3> even_origin(const std::vector<Surfel<3>>& surfels) {
  LatticePoint<3> least = surfels.front().cell().coordinates, greatest = least;
  for (const Surfel<3>& surfel : surfels) {
    least = least.cwiseMin(surfel.cell().coordinates);
    greatest = greatest.cwiseMax(surfel.cell().coordinates);
  }
  for (int k = 0; k < 3; ++k) least[k] -= least[k] & 1;
  if ((greatest - least).maxCoeff() > std::numeric_limits<std::uint16_t>::max())
    throw InputError("too long for a surface to show");
  return least;
}

std::vector<std::int8_t> directions(const Estimates& estimates) {
  std::array<const std::vector<double>*, 6> columns{};
  for (std::size_t k = 0; k < 6; ++k) columns[k] = &estimates[kDirections[k]];
  std::vector<std::int8_t> result;
  for (std::size_t i = 0; i < columns[0]->size(); ++i)
    for (const auto* column : columns) result.push_back(std::int8_t(std::lround(127 * (*column)[i])));
  return result;
}

}  // namespace

ordered_json surface_description(const RecordedSurface& surface) {
  const Record& first = *surface.records.front();
  ordered_json estimators = ordered_json::array();
  for (std::size_t i = 0; i < surface.records.size(); ++i) {
    ordered_json estimator = setting_json(*surface.records[i]);
    estimator["quantities"] = surface.quantities[i];
    estimator["directions"] = has_directions(surface.estimates[i]);
    estimator["errors"] = to_json(*surface.records[i])["errors"];
    estimators.push_back(std::move(estimator));
  }
  return {{"shape", first.shape},       {"h", first.h},
          {"offset", first.offset},     {"surfels", first.surfels},
          {"singular", first.singular}, {"estimators", estimators}};
}

ordered_json surface_description(const DetailSurface& surface) {
  ordered_json estimators = ordered_json::array();
  for (std::size_t i = 0; i < surface.digital_radii.size(); ++i)
    estimators.push_back({{"estimator", surface.estimator},
                          {"digital_radius", surface.digital_radii[i]},
                          {"quantities", surface.quantities[i]},
                          {"directions", has_directions(surface.estimates[i])}});
  return {{"shape", surface.input},
          {"h", surface.h.value},
          {"surfels", surface.surfels.size()},
          {"side_by_side", true},
          {"estimators", estimators}};
}

ordered_json surface_arrays(const Surface& surface) {
  const LatticePoint<3> origin = even_origin(surface.surfels);
  std::vector<std::uint16_t> cells;
  std::vector<std::int8_t> signs;
  for (const Surfel<3>& surfel : surface.surfels) {
    for (const auto coordinate : LatticePoint<3>(surfel.cell().coordinates - origin))
      cells.push_back(std::uint16_t(coordinate));
    signs.push_back(surfel.sign);
  }

  ordered_json truth = ordered_json::object();
  for (std::size_t q = 0; q < surface.truth.quantities.size(); ++q) {
    std::vector<float> values(surface.truth.columns[q].begin(), surface.truth.columns[q].end());
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!surface.truth.known[i]) values[i] = std::numeric_limits<float>::quiet_NaN();
    truth[surface.truth.quantities[q]] = base64(values);
  }

  ordered_json estimates = ordered_json::array(), frames = ordered_json::array();
  for (std::size_t i = 0; i < surface.estimates.size(); ++i) {
    const Estimates& of_one = surface.estimates[i];
    ordered_json columns = ordered_json::object();
    for (const std::string& name : surface.quantities[i])
      columns[name] = base64(std::vector<float>(of_one[name].begin(), of_one[name].end()));
    estimates.push_back(std::move(columns));
    frames.push_back(has_directions(of_one) ? ordered_json(base64(directions(of_one))) : ordered_json());
  }
  return {{"origin", {origin[0], origin[1], origin[2]}},
          {"cells", base64(cells)},
          {"signs", base64(signs)},
          {"truth", truth},
          {"estimates", estimates},
          {"directions", frames}};
}

}  // namespace gridstep
