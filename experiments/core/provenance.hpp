#pragma once

#include <nlohmann/json_fwd.hpp>

namespace gridstep {

/// Who produced a number: commit and whether the sources differed from it, versions of program, compiler and
/// libraries, build type and flags, processor and system, the definition of the norms, and the time (UTC, ISO
/// 8601). Nothing names the user or the host.
nlohmann::ordered_json provenance();

}  // namespace gridstep
