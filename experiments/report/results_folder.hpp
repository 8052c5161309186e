#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/record.hpp"

namespace gridstep {

/// What an earlier study left in its folder.
struct ResultsFolder {
  std::filesystem::path path;
  nlohmann::json summary;
  std::vector<Record> records;  ///< none of a study of detail

  /// Whether it is that of one surface at several radii: experiments/detail_study.hpp.
  bool of_detail() const { return summary.contains("detail"); }
};

/// Reads summary.json and, but for a study of detail, records.jsonl; checks that they have all that a report shows.
/// @throws InputError naming the file and what is wrong with it: unreadable, no JSON, of another schema, a
/// field missing or of the wrong type, or not both of one run.
ResultsFolder read_results(const std::filesystem::path& folder);

}  // namespace gridstep
