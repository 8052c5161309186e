#include "experiments/report/detail_surface.hpp"

#include <fmt/format.h>

#include <cmath>

#include "experiments/distribution.hpp"
#include "shapes/base/contracts.hpp"
#include "shapes/files/surface_file.hpp"

namespace gridstep {

namespace {

using nlohmann::json;

std::filesystem::path ply_of(const json& level, const std::filesystem::path& folder) {
  for (const std::string file : level["surfaces"])
    if (file.ends_with(".ply")) return folder / file;
  throw InputError(fmt::format("no PLY file of R/h = {:g}", level["digital_radius"].get<double>()));
}

/// The values are written with all their digits, and so are their quantiles.
void require_same_spread(const std::string& quantity, const std::vector<double>& values, const json& spread) {
  if (json(to_json(distribution_of(values)))["quantiles"] != spread["quantiles"])
    throw InputError(fmt::format("the values of {} are not those of summary.json", quantity));
}

void require_finite(const PlySurface& ply) {
  for (std::size_t c = 0; c < ply.titles.size(); ++c)
    for (const double value : ply.columns[c])
      if (!std::isfinite(value)) throw InputError(fmt::format("a value of {} is not finite", ply.titles[c]));
}

/// What a radius has of the surface, checked against what the summary tells of it.
void add_level(DetailSurface& surface, const json& level, double surfels, PlySurface ply) {
  if (ply.mesh.quads.empty() || double(ply.mesh.quads.size()) != surfels)
    throw InputError(
        fmt::format("{} faces, where summary.json tells of {} surfels", ply.mesh.quads.size(), surfels));
  std::vector<Surfel<3>> faces = surfels_of(ply.mesh, surface.h);
  if (surface.surfels.empty())
    surface.surfels = std::move(faces);
  else if (faces != surface.surfels)
    throw InputError("another surface than at the first radius");

  require_finite(ply);
  const json& spreads = level["quantities"];
  std::vector<std::string> quantities;
  for (std::size_t c = 0; c < ply.titles.size(); ++c)
    if (const auto spread = spreads.find(ply.titles[c]); spread != spreads.end()) {
      require_same_spread(ply.titles[c], ply.columns[c], *spread);
      quantities.push_back(ply.titles[c]);
    }
  if (quantities.size() != spreads.size())
    throw InputError(fmt::format("values of {} quantities, where summary.json tells of {}", quantities.size(),
                                 spreads.size()));
  surface.digital_radii.push_back(level["digital_radius"]);
  surface.quantities.push_back(std::move(quantities));
  surface.estimates.push_back({std::move(ply.titles), std::move(ply.columns)});
}

}  // namespace

DetailSurface read_detail_surface(const ResultsFolder& folder) {
  const json& detail = folder.summary["detail"];
  DetailSurface surface;
  surface.input = detail["input"];
  surface.h = {detail["h"]};
  surface.estimator = detail["estimator"];
  const double surfels = detail["surfels"];
  if (!(surfels <= double(most_surfels_shown)))
    throw InputError(fmt::format("{} at h = {:g}: {} surfels, more than the {} that a page shows",
                                 surface.input, surface.h.value, surfels, most_surfels_shown));
  for (const json& level : detail["levels"]) {
    const std::string path = ply_of(level, folder.path).string();
    ByteReader file = open_file(path);
    PlySurface ply = read_ply(file);
    try {
      add_level(surface, level, surfels, std::move(ply));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", path, error.what()));
    }
  }
  return surface;
}

}  // namespace gridstep
