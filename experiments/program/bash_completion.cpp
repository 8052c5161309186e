#include <fmt/format.h>

#include <map>
#include <set>

#include "estimators/catalogue.hpp"
#include "experiments/catalogue.hpp"
#include "experiments/program/interface.hpp"
#include "shapes/analytic/catalogue.hpp"

namespace gridstep {

namespace {

template <class Entries>
std::string names_of(const Entries& entries) {
  std::string names;
  for (const auto& entry : entries) names += (names.empty() ? "" : " ") + entry.name;
  return names;
}

/// normal_x, normal_y and normal_z are asked for as normal.
std::string quantity_names() {
  std::set<std::string> names;
  const auto add = [&names](const auto& variant) {
    if (!variant) return;
    for (const Quantity& quantity : variant->quantities)
      names.insert(quantity.name.substr(0, quantity.name.find('_')));
  };
  for (const EstimatorEntry& entry : estimator_catalogue()) {
    add(entry.in_2d);
    add(entry.in_3d);
  }
  return fmt::format("{}", fmt::join(names, " "));
}

/// By option, or by command for what stands alone: the words that may follow. For others, files.
std::map<std::string, std::string> known_words() {
  return {{"--shape", names_of(shape_catalogue())},
          {"--estimator", names_of(estimator_catalogue())},
          {"--quantity", quantity_names()},
          {"--evaluation", "bricks masks full"},
          {"--centre", "spels surfel"},
          {"--type", "uint8 int8 uint16 int16 uint32 int32 uint64 int64 float32 float64"},
          {"list", "shapes estimators studies"},
          {"study", names_of(study_catalogue())}};
}

std::string options_of(const CLI::App& app) {
  std::string names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) names += (names.empty() ? "--" : " --") + name;
  }
  return names;
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::string commands, options, words;
  for (const CLI::App* command : program.get_subcommands({})) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    options += fmt::format("    {}) options='{}' ;;\n", command->get_name(), options_of(*command));
  }
  for (const auto& [place, known] : known_words())
    words += fmt::format("    {}) words='{}' ;;\n", place, known);
  return fmt::format(
      R"bash(# bash completion for gridstep. Made by its build from the options and the catalogues.
_gridstep() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command=${{COMP_WORDS[1]}} options='' words=''
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{} {}' -- "$current")
    return
  fi
  case $command in
{}  esac
  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    return
  fi
  [[ $before == -* ]] || before=$command
  case $before in
{}  esac
  # NAME,NAME: the last one is completed. Without any word, bash completes files.
  local list=''
  [[ $current == *,* ]] && list=${{current%,*}},
  mapfile -t COMPREPLY < <(compgen -W "$words" -P "$list" -- "${{current##*,}}")
  # A study may also be a file.
  [[ $before != study ]] || mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -- "$current")
}}
complete -o default -F _gridstep gridstep
)bash",
      commands, options_of(program), options, words);
}

}  // namespace gridstep
