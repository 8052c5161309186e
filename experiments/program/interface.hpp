#pragma once

#include <CLI/CLI.hpp>
#include <string>

// What the build makes of the program's commands and their help, to be installed beside it.
namespace gridstep {

/// gridstep.1, in the macros of man(7).
std::string man_page(const CLI::App& program, const std::string& version);

/// For bash: commands, options, and the names in the catalogues.
std::string bash_completion(const CLI::App& program);

}  // namespace gridstep
