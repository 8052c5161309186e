#pragma once

namespace gridstep {

/// What the build knows of the program. Determined at every build, not at configuration, which a commit does
/// not rerun.
struct BuildInfo {
  const char* version;
  const char* commit;  ///< "unknown" outside a git checkout of the program itself
  bool dirty;          ///< the sources that make the program differ from the commit
  const char* type;    ///< Release, Debug, ...
  const char* flags;
};

const BuildInfo& build_info();

}  // namespace gridstep
