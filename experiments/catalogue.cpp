#include "experiments/catalogue.hpp"

#include <fmt/format.h>

#include "shapes/base/contracts.hpp"

namespace gridstep {

#define GRIDSTEP_STUDY(id) StudyEntry describe_##id();
#include "experiments/catalogue.inc"
#undef GRIDSTEP_STUDY

const std::vector<StudyEntry>& study_catalogue() {
  static const std::vector<StudyEntry> entries{
#define GRIDSTEP_STUDY(id) describe_##id(),
#include "experiments/catalogue.inc"
#undef GRIDSTEP_STUDY
  };
  return entries;
}

const StudyEntry& find_study(const std::string& name) {
  for (const StudyEntry& entry : study_catalogue())
    if (entry.name == name) return entry;
  std::string known;
  for (const StudyEntry& entry : study_catalogue()) known += (known.empty() ? "" : ", ") + entry.name;
  throw InputError(fmt::format("unknown study '{}' (and no such file); known: {}", name, known));
}

}  // namespace gridstep
