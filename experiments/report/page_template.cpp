// The one source that holds the built page: a raw string, which scripts/report/build_page.cmake writes.
#include "experiments/report/page.hpp"

namespace gridstep {

std::string_view page_template() {
  static constexpr char text[] =
#include "gridstep_report_page.inc"
      ;
  return {text, sizeof text - 1};
}

}  // namespace gridstep
