#pragma once

#include <CLI/CLI.hpp>

namespace gridstep {

// Each adds its command, with help and an example, to the program; a callback runs it and throws InputError
// for whatever is wrong with the input.
void add_list_command(CLI::App& program);
void add_study_command(CLI::App& program);
void add_estimate_command(CLI::App& program);

}  // namespace gridstep
