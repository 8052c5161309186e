#include <fmt/format.h>

#include "experiments/program/interface.hpp"

namespace gridstep {

namespace {

/// Text as it is: roff gives backslashes, minus signs, and dots and quotes at the start of a line meanings of their own.
std::string roff(std::string_view text) {
  std::string result;
  bool line_starts = true;
  for (const char c : text) {
    if (line_starts && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '^')
      result += "\\(ha";
    else
      result += c;
    line_starts = c == '\n';
  }
  return result;
}

/// Lines that stay lines.
std::string verbatim(const std::string& text) {
  return fmt::format(".nf\n{}\n.fi\n", roff(text));
}

std::string option_entry(const CLI::Option& option) {
  const std::string value = option.get_items_expected_max() > 0 ? option.get_type_name() : "";
  const std::string names =
      option.get_positional() ? option.get_name(true, false) : option.get_name(false, true);
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(names),
                     value.empty() ? "" : " \\fI" + roff(value) + "\\fR", roff(option.get_description()));
}

std::string options_of(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) text += option_entry(*option);
  return text;
}

}  // namespace

std::string man_page(const CLI::App& program, const std::string& version) {
  const std::string& summary = program.get_description();  // gridstep: what it is
  // Without a date: the same sources make the same page.
  std::string text = fmt::format(".TH GRIDSTEP 1 \"\" \"gridstep {}\" \"User Commands\"\n", roff(version));
  text += fmt::format(".SH NAME\ngridstep \\- {}\n", roff(summary.substr(summary.find(": ") + 2)));
  text +=
      ".SH SYNOPSIS\n\\fBgridstep\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH OPTIONS\n" + options_of(program);
  text += ".SH EXAMPLES\n" + verbatim(program.get_footer().substr(program.get_footer().find('\n') + 1));
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands({}))
    text +=
        fmt::format(".SS gridstep {}\n{}\n{}.PP\n{}", command->get_name(), roff(command->get_description()),
                    options_of(*command), verbatim(command->get_footer()));
  return text;
}

}  // namespace gridstep
