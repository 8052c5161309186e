#include "experiments/report/results_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <set>
#include <system_error>

#include "experiments/core/json_reader.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

using nlohmann::json;

void check_schema(JsonReader& head) {
  if (head.integer("schema") != 1) head.fail("schema", "1");
  JsonReader study = head.object("study");
  study.text("name");
  head.object("provenance");
}

/// A number or null, such as an interval without an end.
void check_number_or_null(JsonReader& reader, const std::string& key) {
  if (!reader.value(key).is_null()) reader.number(key);
}

void check_setting(JsonReader& setting) {
  setting.text("shape");
  setting.integer("dimension");
  setting.number("noise");
  setting.boolean("rotated", false);
  setting.text("estimator");
  for (const char* key : {"k", "alpha"}) check_number_or_null(setting, key);
  if (!setting.value("centre").is_null()) setting.text("centre");
}

void check_interval(JsonReader& reader) {
  const json& ends = reader.value("interval");
  const auto is_end = [](const json& end) { return end.is_null() || end.is_number(); };
  if (!ends.is_array() || ends.size() != 2 || !is_end(ends[0]) || !is_end(ends[1]))
    reader.fail("interval", "a list of two numbers");
}

void check_convergence(JsonReader& series) {
  check_setting(series);
  for (const char* key : {"quantity", "norm", "verdict"}) series.text(key);
  for (const char* key : {"slope", "constant", "theil_sen", "envelope_slope"}) series.number(key);
  check_number_or_null(series, "expected");
  check_interval(series);
  for (JsonReader& level : series.objects("levels")) {
    level.number("h");
    level.numbers("errors");
  }
  for (JsonReader& row : series.objects("scan")) {
    for (const char* key : {"dropped", "coarsest", "slope"}) row.number(key);
    check_interval(row);
  }
}

void check_cost(JsonReader& cost) {
  check_setting(cost);
  if (!cost.value("evaluation").is_null()) cost.text("evaluation");
  for (const char* key : {"time_in_h", "cells_in_h", "expected_in_h"}) check_number_or_null(cost, key);
  for (JsonReader& step : cost.objects("steps"))
    for (const char* key : {"h", "surfels", "seconds_eval", "cells_visited"}) step.number(key);
}

void check_work_precision(JsonReader& curve) {
  check_setting(curve);
  for (const char* key : {"quantity", "norm"}) curve.text(key);
  for (JsonReader& point : curve.objects("points"))
    for (const char* key : {"h", "seconds", "error"}) point.number(key);
}

void check_detail(JsonReader& detail) {
  for (const char* key : {"input", "estimator"}) detail.text(key);
  for (const char* key : {"h", "voxels", "surfels", "components"}) detail.number(key);
  std::vector<JsonReader> levels = detail.objects("levels");
  if (levels.empty()) detail.fail("levels", "a list of at least one level");
  std::set<std::string> names_of_first;
  for (JsonReader& level : levels) {
    for (const char* key : {"radius", "digital_radius"}) level.number(key);
    level.texts("surfaces");
    JsonReader quantities = level.object("quantities");
    std::set<std::string> names;
    for (const auto& [quantity, ignored] : level.value("quantities").items()) names.insert(quantity);
    if (&level == &levels.front()) names_of_first = names;
    if (names.empty() || names != names_of_first) level.fail("not the quantities of the first level");
    for (const std::string& quantity : names) {
      JsonReader spread = quantities.object(quantity);
      spread.number("mean");
      if (spread.numbers("quantiles").size() != spread.numbers("probabilities").size())
        spread.fail("quantiles", "as long as 'probabilities'");
    }
  }
}

void check_summary(const json& summary, const std::string& source) {
  JsonReader reader(summary, source);
  check_schema(reader);
  if (reader.has("detail")) {
    JsonReader detail = reader.object("detail");
    return check_detail(detail);
  }
  for (JsonReader& series : reader.objects("convergence")) check_convergence(series);
  for (JsonReader& cost : reader.objects("cost")) check_cost(cost);
  for (JsonReader& curve : reader.objects("work_precision")) check_work_precision(curve);
}

/// The head, and every further line as a record.
std::pair<json, std::vector<Record>> read_records(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(
        fmt::format("{}: cannot be read: {}", file.string(), std::generic_category().message(errno)));
  json head;
  std::vector<Record> records;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) try {
      if (number == 1)
        head = json::parse(line);
      else
        records.push_back(record_from(nlohmann::ordered_json::parse(line)));
    } catch (const json::exception&) {
      throw InputError(fmt::format("{}: line {} is no JSON", file.string(), number));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: line {}: {}", file.string(), number, error.what()));
    }
  return {std::move(head), std::move(records)};
}

}  // namespace

ResultsFolder read_results(const std::filesystem::path& folder) {
  const std::filesystem::path summary_file = folder / "summary.json", records_file = folder / "records.jsonl";
  ResultsFolder results{folder, load_json(summary_file), {}};
  check_summary(results.summary, summary_file.string());
  if (results.of_detail()) return results;
  auto [head, records] = read_records(records_file);
  JsonReader reader(head, records_file.string());
  check_schema(reader);
  for (const char* key : {"study", "provenance"})
    if (head[key] != results.summary[key])
      reader.fail(
          fmt::format("'{}' differs from that of {}: not of the same run", key, summary_file.string()));
  results.records = std::move(records);
  return results;
}

}  // namespace gridstep
