#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

#include "experiments/core/build_info.hpp"
#include "experiments/core/output_file.hpp"
#include "experiments/program/commands.hpp"
#include "experiments/program/interface.hpp"
#include "experiments/program/say.hpp"

namespace {

/// An error takes one line, also where it quotes a file or an option that holds more.
void print_error(std::string message) {
  for (char& c : message)
    if (c == '\n' || c == '\r') c = ' ';
  fmt::print(stderr, "gridstep: {}\n", message);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program{"gridstep: multigrid convergence of digital curvature estimators"};
  program.set_version_flag("--version", fmt::format("gridstep {} ({}{})", gridstep::build_info().version,
                                                    gridstep::build_info().commit,
                                                    gridstep::build_info().dirty ? ", modified" : ""));
  // None is told below: by itself, the check would come before that of an unknown command, and hide its name.
  program.require_subcommand(0, 1);
  program.get_formatter()->column_width(
      std::min<std::size_t>(34, gridstep::line_width(stdout).value_or(80) / 3));
  program.footer(
      "Examples:\n"
      "  gridstep list shapes\n"
      "  gridstep study paper-2d --quick --out results/raw/paper-2d\n"
      "  gridstep estimate --shape ellipse:a=20,b=7 --h 0.1 --estimator ii --k 5 --csv ellipse.csv\n"
      "  gridstep estimate --volume al.vol --radius 7 --quantity gaussian --out al.ply\n"
      "  gridstep report results/raw/paper-2d\n"
      "A command tells more: gridstep estimate --help");
  gridstep::add_list_command(program);
  gridstep::add_study_command(program);
  gridstep::add_estimate_command(program);
  gridstep::add_convert_command(program);
  gridstep::add_report_command(program);
  // For the build, which installs what they write (CMakeLists.txt).
  std::string man, completion;
  program.add_option("--write-man", man)->group("");
  program.add_option("--write-completion", completion)->group("");
  try {
    program.parse(argc, argv);
    if (!man.empty()) gridstep::write_whole(man, gridstep::man_page(program, gridstep::build_info().version));
    if (!completion.empty()) gridstep::write_whole(completion, gridstep::bash_completion(program));
    if (!man.empty() || !completion.empty()) return 0;
    if (program.get_subcommands().empty())
      throw CLI::RequiredError("A command: list, study, estimate, convert or report");
    // A full disk shows when the buffer is written at the latest: after all the work, but not unnoticed.
    if (std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(), "standard output cannot be written");
    return 0;
  } catch (const CLI::CallForHelp&) {
    gridstep::say_text(stdout, program.help());
    return 0;
  } catch (const CLI::Success& request) {  // --version
    return program.exit(request);
  } catch (const CLI::ExtrasError& error) {
    const std::vector<std::string> extras = program.remaining();
    const bool is_command =
        program.get_subcommands().empty() && !extras.empty() && !extras[0].starts_with('-');
    fmt::print(stderr, "gridstep: {}\n",
               is_command ? fmt::format("unknown command '{}'; known: list, study, estimate, convert, report",
                                        extras[0])
                          : fmt::format("{} (see gridstep --help)", error.what()));
    return 2;
  } catch (const CLI::ParseError& error) {
    print_error(fmt::format("{} (see gridstep --help)", error.what()));
    return 2;
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
    return 1;
  } catch (const std::exception& error) {
    print_error(error.what());
    return 1;
  }
}
