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
  std::vector<Record> records;
};

/// Reads summary.json and records.jsonl, and checks that they have all that a report shows.
/// @throws InputError naming the file and what is wrong with it: unreadable, no JSON, of another schema, a
/// field missing or of the wrong type, or not both of one run.
ResultsFolder read_results(const std::filesystem::path& folder);

}  // namespace gridstep
