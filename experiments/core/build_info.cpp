// The one source that includes the generated header: a commit recompiles these lines and nothing else.
#include "experiments/core/build_info.hpp"

#include "gridstep_build.hpp"

namespace gridstep {

const BuildInfo& build_info() {
  static constexpr BuildInfo info{GRIDSTEP_VERSION, GRIDSTEP_COMMIT, GRIDSTEP_DIRTY, GRIDSTEP_BUILD_TYPE,
                                  GRIDSTEP_FLAGS};
  return info;
}

}  // namespace gridstep
