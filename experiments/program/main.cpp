#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "experiments/core/build_info.hpp"
#include "experiments/program/commands.hpp"
#include "shapes/base/contracts.hpp"

int main(int argc, char** argv) {
  CLI::App program{"gridstep: multigrid convergence of digital curvature estimators"};
  program.set_version_flag("--version", fmt::format("gridstep {} ({}{})", gridstep::build_info().version,
                                                    gridstep::build_info().commit,
                                                    gridstep::build_info().dirty ? ", modified" : ""));
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  program.footer(
      "Examples:\n"
      "  gridstep list shapes\n"
      "  gridstep study paper-2d --quick --out results/raw/paper-2d\n"
      "  gridstep estimate --shape ellipse:a=20,b=7 --h 0.1 --estimator ii --k 5 --csv ellipse.csv\n"
      "A command tells more: gridstep estimate --help");
  gridstep::add_list_command(program);
  gridstep::add_study_command(program);
  gridstep::add_estimate_command(program);
  try {
    // The parser would only say that a command is missing.
    const auto names = [&](const CLI::App* command) { return argc > 1 && command->check_name(argv[1]); };
    if (argc > 1 && argv[1][0] != '-' && program.get_subcommands(names).empty())
      throw gridstep::InputError(fmt::format("unknown command '{}'; known: list, study, estimate", argv[1]));
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& request) {  // --help, --version
    return program.exit(request);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "gridstep: {} (see gridstep --help)\n", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "gridstep: out of memory\n");
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "gridstep: {}\n", error.what());
    return 1;
  }
}
