// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <vector>

#include "cli/terminal/terminal.h"

namespace sinew {
namespace {

struct CommandOption {
  std::vector<std::string> names;  ///< "--out"; "model" of an argument without dashes
  std::string description;
  bool positional = false, required = false, takes_value = false;
};

struct Command {
  std::string name, description;
  std::vector<CommandOption> options;
};

CommandOption described(const CLI::Option& option) {
  CommandOption result;
  result.positional = option.get_positional();
  result.required = option.get_required();
  result.takes_value = option.get_items_expected_max() > 0;
  result.description = option.get_description();
  if (result.positional) result.names.push_back(option.get_name(true, false));
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  return result;
}

/// Options of the command and of the groups in it.
void add_options(const CLI::App& app, std::vector<CommandOption>& options) {
  for (const CLI::Option* option : app.get_options()) options.push_back(described(*option));
  for (const CLI::App* group :
       app.get_subcommands([](const CLI::App* each) { return each->get_name().empty(); }))
    add_options(*group, options);
}

std::vector<Command> commands_of(const CLI::App& app) {
  std::vector<Command> commands;
  for (const CLI::App* each :
       app.get_subcommands([](const CLI::App* any) { return !any->get_name().empty(); })) {
    commands.push_back({each->get_name(), each->get_description(), {}});
    add_options(*each, commands.back().options);
  }
  return commands;
}

/// As roff prints it: no line is a request, and a dash is one that can be copied.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c == '\n' ? ' ' : c;
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string roff_option(const CommandOption& option) {
  std::string names;
  for (const std::string& name : option.names)
    names +=
        (names.empty() ? "" : ", ") + (option.positional ? fmt::format("\\fI{}\\fR", roff(name))
                                                         : fmt::format("\\fB{}\\fR", roff(name)));
  if (option.takes_value && !option.positional) names += " \\fIvalue\\fR";
  return fmt::format(
      ".TP\n{}{}\n{}\n", names, option.required ? " (required)" : "",
      roff(option.description.empty() ? "See the documentation" : option.description));
}

std::string roff_command(const Command& command) {
  std::string synopsis = fmt::format("\\fBsinew {}\\fR", roff(command.name)), options;
  for (const CommandOption& option : command.options) {
    if (option.positional) synopsis += fmt::format(" \\fI{}\\fR", roff(option.names.front()));
    options += roff_option(option);
  }
  return fmt::format(".SS {}\n{} [\\fIoptions\\fR]\n.PP\n{}.\n{}", roff(command.name), synopsis,
                     roff(command.description), options);
}

std::string words_with_dashes(const Command& command) {
  std::string words;
  for (const CommandOption& option : command.options)
    for (const std::string& name : option.names)
      if (name.starts_with('-')) words += (words.empty() ? "" : " ") + name;
  return words;
}

/// In single quotes of a shell; brackets and colons mean something to zsh's _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else if (c == '[' || c == ']' || c == ':')
      out += fmt::format("\\{}", c);
    else
      out += c;
  }
  return out;
}

std::string zsh_arguments(const Command& command) {
  std::string text;
  for (const CommandOption& option : command.options) {
    if (option.positional) continue;
    for (const std::string& name : option.names)
      text += fmt::format(" \\\n        '*{}[{}]{}'", name, zsh_text(option.description),
                          option.takes_value ? ":value:_files" : "");
  }
  return fmt::format("      {})\n        _arguments{} \\\n        '*:file:_files' ;;\n",
                     command.name, text);
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page =
      ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n"
      ".TH SINEW 1 \"\" sinew \"User commands\"\n"
      ".SH NAME\nsinew \\- symbolic models of tendon\\-driven hands, emitted as real\\-time C\n"
      ".SH SYNOPSIS\n\\fBsinew\\fR \\fIcommand\\fR [\\fIoptions\\fR]\n.br\n"
      "\\fBsinew\\fR \\fB\\-\\-version\\fR\n"
      ".SH DESCRIPTION\nTurns the description of a tendon\\-driven robot hand or of any robot in "
      "URDF into optimised, allocation\\-free C, simulates with that C, and diagnoses measured "
      "logs.\n.SH COMMANDS\n";
  for (const Command& command : commands_of(app)) page += roff_command(command);
  page +=
      ".SH EXIT STATUS\n.TP\n0\nfine\n.TP\n1\na finding: something differs, or was found\n.TP\n2\n"
      "wrong usage or input; with \\fB\\-\\-json\\fR standard output has the errors as JSON\n"
      ".SH EXAMPLES\n.nf\nsinew import robot.urdf \\-\\-out models/robot\n"
      "sinew generate models/robot\nsinew dump models/robot \\-\\-equations\n.fi\n"
      ".SH FILES\n.TP\nmodels/<name>/mechanism.toml, mass_properties.csv\n"
      "a model; generated/<name>/ takes its C\n.TP\n~/.cache/sinew/\n"
      "models that were compiled before; may be deleted at any time\n"
      ".SH ENVIRONMENT\n.TP\nCC\nthe C compiler of \\fBsimulate\\fR, \\fBdiagnose\\fR and "
      "\\fBfigures\\fR\n.TP\nSINEW_CACHE_DIR\nanother folder than ~/.cache/sinew; empty: nothing "
      "is kept\n";
  return page;
}

std::string bash_completion(const CLI::App& app) {
  std::string names, cases;
  for (const Command& command : commands_of(app)) {
    names += (names.empty() ? "" : " ") + command.name;
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command.name, words_with_dashes(command));
  }
  return "# SPDX-License-Identifier: GPL-3.0-or-later\n"
         "# Completion of sinew for bash; printed by 'sinew manual --bash'.\n"
         "_sinew() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} words=\"\"\n"
         "  COMPREPLY=()\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         names +
         " --help --version\" -- \"$current\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  if [[ $current == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "  else\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _sinew sinew\n";
}

std::string zsh_completion(const CLI::App& app) {
  std::string names, cases;
  for (const Command& command : commands_of(app)) {
    names += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.description));
    cases += zsh_arguments(command);
  }
  return "#compdef sinew\n"
         "# SPDX-License-Identifier: GPL-3.0-or-later\n"
         "# Completion of sinew for zsh; printed by 'sinew manual --zsh'.\n"
         "_sinew() {\n"
         "  local -a commands\n"
         "  commands=(\n" +
         names +
         "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  local command=$words[2]\n"
         "  shift words\n"
         "  (( CURRENT-- ))\n"
         "  case $command in\n" +
         cases +
         "  esac\n"
         "}\n"
         "_sinew \"$@\"\n";
}

void add_manual_command(CLI::App& app, int&) {
  struct Shells {
    bool bash = false, zsh = false;
  };
  auto shells = std::make_shared<Shells>();
  CLI::App* command =
      app.add_subcommand("manual", "Print the manual page, or completions for a shell");
  CLI::Option* bash = command->add_flag("--bash", shells->bash, "The completion for bash");
  command->add_flag("--zsh", shells->zsh, "The completion for zsh")->excludes(bash);
  command->callback([&app, shells] {
    tell("{}", shells->bash  ? bash_completion(app)
               : shells->zsh ? zsh_completion(app)
                             : manual_page(app));
  });
}

}  // namespace sinew
