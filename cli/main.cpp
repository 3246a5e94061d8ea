// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/clear_message.h"
#include "cli/diagnose.h"
#include "cli/effects.h"
#include "cli/figures/figures.h"
#include "cli/generate.h"
#include "cli/identify.h"
#include "cli/import.h"
#include "cli/inspect.h"
#include "cli/simulate.h"

namespace {

constexpr int wrong_usage_or_input = 2;

bool has_command(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : app.get_subcommands({}))
    if (command->get_name() == name) return true;
  return false;
}

std::string command_names(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands({}))
    names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  int exit_status = 0;
  CLI::App app{"sinew: symbolic models of tendon-driven hands, emitted as real-time C"};
  app.require_subcommand(1);
  sinew::add_generate_command(app, exit_status);
  sinew::add_check_command(app, exit_status);
  sinew::add_cost_command(app, exit_status);
  sinew::add_dump_command(app, exit_status);
  sinew::add_import_command(app, exit_status);
  sinew::add_figures_command(app, exit_status);
  sinew::add_simulate_command(app, exit_status);
  sinew::add_identify_command(app, exit_status);
  sinew::add_diagnose_command(app, exit_status);
  sinew::add_effects_command(app, exit_status);
  if (argc > 1 && argv[1][0] != '-' && !has_command(app, argv[1])) {
    fmt::print(stderr, "sinew: no command is called '{}'; expected one of {}\n", argv[1],
               command_names(app));
    return wrong_usage_or_input;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : wrong_usage_or_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "sinew: {}\n", sinew::clear_message(error));
    return wrong_usage_or_input;
  } catch (...) {
    fmt::print(stderr, "sinew: something that was not foreseen went wrong; please report it\n");
    return wrong_usage_or_input;
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "sinew: the output cannot be written\n");
    return wrong_usage_or_input;
  }
  return exit_status;
}
