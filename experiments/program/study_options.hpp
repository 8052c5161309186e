#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace gridstep {

/// The options of gridstep study, as they were given.
struct StudyOptions {
  std::string study, out;
  bool quick = false, full = false, resume = false, csv = false, latex = false, json = false;
  int threads = 0;
  std::optional<std::uint64_t> seed;
  std::string volume;                    ///< of a study of detail, in place of the one in its JSON
  std::vector<double> threshold, radii;  ///< likewise
};

/// Whether it is new. @throws InputError where it cannot be made.
bool make_folder(const std::filesystem::path& folder);

/// A study of one surface at several radii: experiments/detail_study.hpp.
void run_detail_study(const nlohmann::json& json, const StudyOptions& options,
                      const std::filesystem::path& folder);

}  // namespace gridstep
