// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/generate.h"
#include "cli/import.h"
#include "cli/inspect.h"

namespace {

constexpr int wrong_usage_or_input = 2;

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
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : wrong_usage_or_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "sinew: {}\n", error.what());
    return wrong_usage_or_input;
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "sinew: the output cannot be written\n");
    return wrong_usage_or_input;
  }
  return exit_status;
}
