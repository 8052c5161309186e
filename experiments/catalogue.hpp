#pragma once

#include <string>
#include <vector>

namespace gridstep {

/// A line of the catalogue: a study that is built in, as the JSON text that a user could have written (see
/// results/README.md), in two sizes.
struct StudyEntry {
  std::string name;
  std::string summary;
  std::string quick;  ///< minutes
  std::string full;   ///< the ranges of the papers
};

/// All studies, in the order of experiments/catalogue.inc.
const std::vector<StudyEntry>& study_catalogue();

/// @throws InputError naming an unknown study and listing the known ones.
const StudyEntry& find_study(const std::string& name);

}  // namespace gridstep
