#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/core/output_file.hpp"
#include "experiments/core/provenance.hpp"
#include "experiments/core/table.hpp"
#include "experiments/detail_study.hpp"
#include "experiments/distribution.hpp"
#include "experiments/memory.hpp"
#include "experiments/program/commands.hpp"
#include "experiments/program/estimation.hpp"
#include "experiments/program/say.hpp"
#include "experiments/program/study_options.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/files/surface_file.hpp"
#include "shapes/files/volume_file.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The digital set, its unit, and what it comes from.
struct Input {
  std::string name;
  GridStep h;
  DigitalSet<3> set;
};

void require_memory_for(const DetailStudy& study, const std::string& name, SetSize size, GridStep h) {
  EstimateOptions options;
  options.estimators = {study.estimator};
  const double most = *std::max_element(study.digital_radii.begin(), study.digital_radii.end());
  const EuclideanLength R{most * h.value};
  require_memory(predicted_memory<3>(chosen<3>(options, R), size, h, R, options), name);
}

Input input_of(const DetailStudy& study) {
  if (study.shape) {
    const auto shape = std::get<std::shared_ptr<const Shape<3>>>(make_shape(*study.shape));
    const std::string name = study.shape->canonical();
    SceneSettings<3> settings;
    settings.h = {study.h};
    require_memory_for(study, name, predicted_size(name, *shape, settings), settings.h);
    return {name, settings.h, make_scene<3>(*shape, settings).set};
  }
  const GreyVolume volume = read_volume(study.volume);
  const GridStep h{study.h > 0 ? study.h : volume.spacing};
  const GreyRange range =
      study.threshold ? GreyRange{study.threshold->first, study.threshold->second} : foreground(volume);
  Input input{study.volume, h, threshold(volume, range)};
  require_memory_for(study, study.volume, size_of(input.set), h);
  return input;
}

/// Coordinates of directions say nothing on their own.
bool is_coordinate(const std::string& quantity) {
  return quantity.ends_with("_x") || quantity.ends_with("_y") || quantity.ends_with("_z");
}

/// Rows of one quantity stand together, for its radii to be compared.
Table table_of(const std::vector<ordered_json>& levels) {
  Table table{
      "", {{"quantity", Align::left}, {"R/h"}, {"least"}, {"5 %"}, {"median"}, {"95 %"}, {"greatest"}}, {}};
  for (const auto& [quantity, ignored] : levels.front()["quantities"].items())
    for (const ordered_json& level : levels) {
      std::vector<std::string> row{quantity, fmt::format("{:g}", level["digital_radius"].get<double>())};
      const ordered_json& spread = level["quantities"][quantity];
      for (std::size_t i = 0; i < spread["probabilities"].size(); ++i)
        for (const double shown : {0.0, 0.05, 0.5, 0.95, 1.0})
          if (spread["probabilities"][i] == shown)
            row.push_back(fmt::format("{:.4g}", spread["quantiles"][i].get<double>()));
      table.rows.push_back(std::move(row));
    }
  return table;
}

}  // namespace

void run_detail_study(const nlohmann::json& json, const StudyOptions& options, const fs::path& folder) {
  if (options.resume) throw InputError("--resume: a study of detail keeps no journal");
  const DetailStudy study = DetailStudy::read(json, options.study);
  const Input input = input_of(study);
  const DigitalSurface<3> surface = connected_boundary(input.set);
  const QuadMesh mesh = quad_mesh(surface.surfels, input.h);
  make_folder(folder);

  EstimateOptions how;
  how.estimators = {study.estimator};
  std::vector<ordered_json> levels;
  std::vector<fs::path> written;
  for (const double cells : study.digital_radii) {
    const EuclideanLength R{cells * input.h.value};
    std::vector<Estimation<3>> estimations = chosen<3>(how, R);
    evaluate<3>(estimations, input.set, surface.surfels, input.h, R, how);
    const Estimation<3>& e = estimations.front();
    ordered_json spreads = ordered_json::object();
    for (std::size_t q = 0; q < e.estimates.quantities.size(); ++q)
      if (!is_coordinate(e.estimates.quantities[q]))
        spreads[e.estimates.quantities[q]] = to_json(distribution_of(e.estimates.columns[q]));
    ordered_json level{{"radius", R.value}, {"digital_radius", cells}, {"quantities", std::move(spreads)}};
    SurfelTable table = surfel_table<3>(estimations, surface.surfels, input.h, surface.component_begin);
    add_estimates(table, e, "", how);
    for (const char* extension : {".vtp", ".ply"}) {
      const fs::path file = folder / fmt::format("radius-{}{}", cells, extension);
      OutputFile out(file);
      surface_format(file.string(), 3).write_mesh(table, mesh, [&](std::string_view bytes) {
        out.write(bytes);
      });
      out.commit();
      level["surfaces"].push_back(file.filename().string());
      written.push_back(file);
    }
    const ordered_json told = to_json(e, how);
    level.update({{"evaluation", told["evaluation"]}, {"work", told["work"]}, {"seconds", told["seconds"]}});
    levels.push_back(std::move(level));
  }

  ordered_json summary{{"schema", 1}, {"study", json}, {"provenance", provenance()}};
  summary["detail"] = {{"input", input.name},
                       {"h", input.h.value},
                       {"estimator", study.estimator},
                       {"voxels", input.set.size()},
                       {"surfels", surface.surfels.size()},
                       {"components", surface.components()},
                       {"levels", levels}};
  write_whole(folder / "summary.json", summary.dump(1) + "\n");
  written.push_back(folder / "summary.json");
  const Table table = table_of(levels);
  if (options.csv) write_whole(folder / "detail.csv", to_csv(table));
  if (options.latex) write_whole(folder / "detail.tex", to_latex(table));
  const std::string on_report = write_report_of(folder);

  if (options.json) return fmt::print("{}\n", summary.dump(1));
  say_table(stdout, table);
  say(stdout, "{}: {} at h = {}, {} surfels, components {}, {}\n", study.name, input.name, input.h.value,
      surface.surfels.size(), surface.components(), study.estimator);
  for (const fs::path& file : written) say(stdout, "written: {}\n", file.string());
  say_text(stdout, on_report);
}

}  // namespace gridstep
