#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace gridstep {

/// Numbers that are read as unsigned: without it, -1 would become 2^64 - 1.
inline std::string not_negative(const std::string& text) {
  return text.starts_with('-') ? text + " is negative" : "";
}

// Each adds its command, with help and an example, to the program; a callback runs it and throws InputError
// for whatever is wrong with the input.
void add_list_command(CLI::App& program);
void add_study_command(CLI::App& program);
void add_estimate_command(CLI::App& program);
void add_convert_command(CLI::App& program);
void add_report_command(CLI::App& program);

/// The report of the results in some folders, whole or not at all. @returns the lines to say: that it is written, and
/// what it leaves out.
std::string write_report(const std::vector<std::string>& folders, const std::filesystem::path& file);

/// That of one folder, in it; where this program has no page, the line says so.
std::string write_report_of(const std::filesystem::path& folder);

}  // namespace gridstep
