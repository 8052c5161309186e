#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/report/results_folder.hpp"

namespace gridstep {

/// The page without data, or nothing where the program was built without Node.
std::string_view page_template();

struct ReportPage {
  std::string html;
  std::vector<std::string> left_out;  ///< surfaces: one line each, which one and why
};

/// One page, with everything in it, that shows the results side by side. Everything on it comes from the files in
/// the folders; a surface that is too large or cannot be made again is left out, and the page says so.
/// @throws InputError where the program was built without the page.
ReportPage report_page(const std::vector<ResultsFolder>& results);

}  // namespace gridstep
