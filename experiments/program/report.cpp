#include <fmt/format.h>

#include <memory>

#include "experiments/core/output_file.hpp"
#include "experiments/program/commands.hpp"
#include "experiments/program/say.hpp"
#include "experiments/report/page.hpp"

namespace gridstep {

std::string write_report(const std::vector<std::string>& folders, const std::filesystem::path& file) {
  std::vector<ResultsFolder> results;
  for (const std::string& folder : folders) results.push_back(read_results(folder));
  const ReportPage page = report_page(results);
  write_whole(file, page.html);
  std::string lines = fmt::format("written: {}\n", file.string());
  for (const std::string& surface : page.left_out) lines += fmt::format("left out of it: {}\n", surface);
  return lines;
}

std::string write_report_of(const std::filesystem::path& folder) {
  if (page_template().empty()) return "not written: report.html, as this gridstep was built without Node\n";
  return write_report({folder.string()}, folder / "report.html");
}

void add_report_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("report", "The page report.html of one study, or of several to compare");
  struct Options {
    std::vector<std::string> folders;
    std::string out;
  };
  const auto options = std::make_shared<Options>();
  command->add_option("folders", options->folders, "Folders of earlier studies")->required();
  command->add_option("--out", options->out,
                      "File to write (default: report.html, in the folder where there is but one)");
  command->footer(
      "Examples:\n"
      "  gridstep report results/raw/paper-2d-quick\n"
      "  gridstep report results/raw/before results/raw/after --out comparison.html");
  command->callback([options] {
    const std::filesystem::path in_folder = options->folders.size() == 1
                                                ? std::filesystem::path(options->folders[0]) / "report.html"
                                                : "report.html";
    const std::filesystem::path file = options->out.empty() ? in_folder : std::filesystem::path(options->out);
    say_text(stdout, write_report(options->folders, file));
  });
}

}  // namespace gridstep
