#include <fmt/format.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/analysis.hpp"
#include "experiments/best_radius.hpp"
#include "experiments/catalogue.hpp"
#include "experiments/core/json_reader.hpp"
#include "experiments/core/output_file.hpp"
#include "experiments/core/provenance.hpp"
#include "experiments/detail_study.hpp"
#include "experiments/fallbacks.hpp"
#include "experiments/isotropy.hpp"
#include "experiments/memory.hpp"
#include "experiments/noise_errors.hpp"
#include "experiments/program/commands.hpp"
#include "experiments/program/say.hpp"
#include "experiments/program/study_options.hpp"
#include "experiments/runner.hpp"
#include "experiments/work_precision.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The study's JSON, and a name for its folder.
std::pair<nlohmann::json, std::string> load(const StudyOptions& options) {
  const bool is_file = fs::is_regular_file(options.study);
  if (is_file && (options.quick || options.full))
    throw InputError("--quick and --full are sizes of built-in studies, not of the file " + options.study);
  if (is_file) return {load_json(options.study), fs::path(options.study).stem().string()};
  const StudyEntry& entry = find_study(options.study);
  return {nlohmann::json::parse(options.full ? entry.full : entry.quick),
          entry.name + (options.full ? "-full" : "-quick")};
}

/// --volume, --threshold and --radii in the study's JSON, which then tells all that was done.
void put_detail_options(nlohmann::json& json, const StudyOptions& options) {
  if (options.volume.empty() && options.threshold.empty() && options.radii.empty()) return;
  if (!DetailStudy::is(json) || !json["detail"].is_object())
    throw InputError("--volume, --threshold and --radii are for level-of-detail, not for " + options.study);
  nlohmann::json& detail = json["detail"];
  if (!options.volume.empty()) {
    detail.erase("shape");
    detail.erase("h");
    detail["volume"] = options.volume;
  }
  if (!options.threshold.empty()) detail["threshold"] = options.threshold;
  if (!options.radii.empty()) detail["digital_radii"] = options.radii;
}

void run(const StudyOptions& options) {
  auto [json, label] = load(options);
  if (options.seed && json.is_object()) json["seed"] = *options.seed;
  put_detail_options(json, options);
  const fs::path folder = options.out.empty() ? fs::path("results/raw") / label : fs::path(options.out);
  if (DetailStudy::is(json)) return run_detail_study(json, options, folder);
  const Study study = Study::read(json, options.study);

  const bool is_new = make_folder(folder);
  const fs::path journal = folder / "journal.jsonl";
  std::error_code ignored;
  double predicted = 0;
  std::vector<Record> records;
  try {
    predicted = predicted_memory(study);
    records = run_study(study, json, {journal, options.resume, stderr});
  } catch (const InputError&) {
    if (is_new) fs::remove(folder, ignored);  // unless there is something in it
    throw;
  }

  const ordered_json head{{"schema", 1}, {"study", json}, {"seed", study.seed}, {"provenance", provenance()}};
  std::string lines = head.dump() + "\n";
  for (const Record& record : records) lines += to_json(record).dump() + "\n";
  const auto convergence = convergence_of(records, study.seed);
  const auto costs = costs_of(records);
  const auto work_precision = work_precision_of(convergence, costs);
  ordered_json summary = head;
  summary["convergence"] = to_json(convergence);
  summary["cost"] = to_json(costs);
  summary["work_precision"] = to_json(work_precision);
  summary["memory"] = {{"predicted_bytes", predicted}, {"peak_bytes", peak_memory()}};
  write_whole(folder / "records.jsonl", lines);
  write_whole(folder / "summary.json", summary.dump(1) + "\n");

  const Table fallbacks = fallback_table(fallbacks_of(records));
  const std::pair<std::string, Table> tables[] = {
      {"convergence", convergence_table(convergence)},
      {"cost", cost_table(costs)},
      {"work-precision", work_precision_table(work_precision)},
      {"equal-error", equal_error_table(work_precision)},
      {"best-radius", best_radius_table(radius_scans_of(convergence))},
      {"noise", noise_table(noise_errors_of(convergence))},
      {"isotropy", isotropy_table(isotropies_of(convergence))},
      {"fallbacks", fallbacks}};
  for (const auto& [name, table] : tables) {
    if (options.csv) write_whole(folder / (name + ".csv"), to_csv(table));
    if (options.latex) write_whole(folder / (name + ".tex"), to_latex(table));
  }
  fs::remove(journal, ignored);
  const std::string on_report = write_report_of(folder);

  if (options.json) return fmt::print("{}\n", summary.dump(1));
  std::int64_t surfels = 0, most_surfels = 0, singular = 0, far = 0;
  double residual = 0;
  for (const Record& record : records) {
    surfels += record.surfels;
    most_surfels = std::max(most_surfels, record.surfels);
    singular += record.singular;
    far += record.far;
    residual = std::max(residual, record.worst_residual);
  }
  for (const std::string& wanted : study.tables)
    for (const auto& [name, table] : tables)
      if (name == wanted) say_table(stdout, table);
  // Whatever is wanted: its errors are not those of the kernel that an estimator is named after.
  if (!fallbacks.rows.empty()) say_table(stdout, fallbacks);
  std::string line = fmt::format("{}: {} records, {} estimates; truth residual <= {:.2g} of the size",
                                 study.name, records.size(), surfels, residual);
  if (singular + far > 0)
    line += fmt::format("; left out of the norms: {} at singular points, {} far from the boundary", singular,
                        far);
  say(stdout, "{}\n{} in the largest digitization\n", line, memory_report(predicted, most_surfels));
  say(stdout, "written: {}\n", (folder / "records.jsonl").string());
  say(stdout, "written: {}\n", (folder / "summary.json").string());
  say_text(stdout, on_report);
}

}  // namespace

bool make_folder(const fs::path& folder) {
  std::error_code error;
  const bool is_new = fs::create_directories(folder, error);
  if (error) throw InputError(fmt::format("--out {}: {}", folder.string(), error.message()));
  return is_new;
}

void add_study_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("study", "Run a study: error curves, slopes and verdicts");
  const auto options = std::make_shared<StudyOptions>();
  command->add_option("study", options->study, "The name of a built-in study, or a JSON file")->required();
  auto* quick = command->add_flag("--quick", options->quick, "A built-in study in its small size (default)");
  command->add_flag("--full", options->full, "A built-in study over the papers' ranges")->excludes(quick);
  command->add_option("--out", options->out, "Folder for the results (default: results/raw/NAME-SIZE)");
  command->add_flag("--resume", options->resume, "Go on with a run that was interrupted");
  command->add_option("--threads", options->threads, "Number of threads (default: all)")
      ->check(CLI::Range(1, 4096));
  command->add_option("--seed", options->seed, "Seed of shifts, rotations, noise and bootstrap")
      ->check(not_negative);
  command->add_flag("--csv", options->csv, "Also write the tables as CSV");
  command->add_flag("--latex", options->latex, "Also write the tables as LaTeX");
  command->add_option("--volume", options->volume,
                      "Of level-of-detail: the volume, such as al.vol (.raw: gridstep convert first)");
  command
      ->add_option("--threshold", options->threshold, "Of level-of-detail: LOW,HIGH, the volume's foreground")
      ->delimiter(',')
      ->expected(1, 2);
  command->add_option("--radii", options->radii, "Of level-of-detail: R/h, in voxels: 14,7 (default)")
      ->delimiter(',');
  command->add_flag("--json", options->json, "Print summary.json instead of tables, for other programs");
  command->footer(
      "Examples:\n"
      "  gridstep study paper-2d\n"
      "  gridstep study level-of-detail --volume al.vol --radii 14,7 --out al\n"
      "  gridstep study my-study.json --out results/raw/mine --csv --latex\n"
      "What a study file holds: results/README.md; those of the built-in ones: gridstep list studies --json");
  command->callback([options] {
    std::optional<tbb::global_control> limit;
    if (options->threads > 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options->threads));
    run(*options);
  });
}

}  // namespace gridstep
