#include "experiments/report/page.hpp"

#include <fmt/format.h>

#include "experiments/report/surface_json.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

using nlohmann::ordered_json;

namespace {

/// Where the page's data go; in scripts/report/src/index.html.
constexpr std::string_view kDataPlace = "<!--gridstep-data-->";

/// As an element that the page reads and browsers do not run. In JSON, '<' is only found in texts; written as
/// an escape, none can end the element.
std::string data_element(const std::string& id, const ordered_json& data) {
  std::string element = fmt::format("<script type=\"application/json\" id=\"{}\">", id);
  for (const char c : data.dump(-1, ' ', false, ordered_json::error_handler_t::replace))
    c == '<' ? element += "\\u003c" : element += c;
  return element + "</script>\n";
}

}  // namespace

ReportPage report_page(const std::vector<ResultsFolder>& results) {
  const std::string_view page = page_template();
  if (page.empty())
    throw InputError("report.html: this gridstep was built without Node, and so without the page");
  const std::size_t place = page.find(kDataPlace);
  expects(place != page.npos, "a place for the data in the page");

  std::string surfaces;
  std::vector<std::string> all_left_out;
  std::size_t count = 0;
  ordered_json studies = ordered_json::array();
  for (const ResultsFolder& folder : results) {
    ordered_json described = ordered_json::array(), left_out = ordered_json::array();
    const auto add = [&](const auto& make_surface) {
      try {
        const auto surface = make_surface();
        const std::string id = fmt::format("surface-{}", count);
        surfaces += data_element(id, surface_arrays(surface));
        described.push_back(surface_description(surface));
        described.back()["id"] = id;
        ++count;
      } catch (const InputError& error) {
        left_out.push_back(error.what());
        all_left_out.push_back(error.what());
      }
    };
    if (folder.of_detail()) add([&] { return read_detail_surface(folder); });
    for (const auto& records : records_of_surfaces(folder.records))
      add([&] { return remake_surface(records); });
    ordered_json study = folder.summary;
    study["folder"] = folder.path.string();
    study["surfaces"] = std::move(described);
    study["surfaces_left_out"] = std::move(left_out);
    studies.push_back(std::move(study));
  }
  std::string text(page.substr(0, place));
  text += data_element("report-data", {{"studies", std::move(studies)}});
  text += surfaces;
  text += page.substr(place + kDataPlace.size());
  return {std::move(text), std::move(all_left_out)};
}

}  // namespace gridstep
