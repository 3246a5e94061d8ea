// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <glog/logging.h>
#include <malloc.h>
#include <signal.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <sstream>

#include "cli/channels.h"
#include "cli/clear_message.h"
#include "cli/diagnose.h"
#include "cli/effects.h"
#include "cli/error_report.h"
#include "cli/figures/figures.h"
#include "cli/generate.h"
#include "cli/identify.h"
#include "cli/import.h"
#include "cli/inspect.h"
#include "cli/manual.h"
#include "cli/parameters.h"
#include "cli/report.h"
#include "cli/simulate.h"
#include "cli/terminal/terminal.h"
#include "generator/outputs/interruption.h"
#include "identification/regression/block_sizes.h"
#include "simulation/emitted/compiling.h"
#include "symbolic/files/identifier.h"
#include "symbolic/files/readable.h"

namespace {

constexpr int wrong_usage_or_input = 2;

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// Options of the command that was given, for what a misspelt one may mean.
std::string help_of(const CLI::App& app) {
  std::string help = app.help();
  for (const CLI::App* command : app.get_subcommands()) help += command->help();
  return help;
}

/// What CLI11 adds to an error.
std::string after_first_line(const std::string& text) {
  const std::size_t end = text.find('\n');
  return end == std::string::npos ? "" : text.substr(end + 1);
}

/// Of commands whose results are files; a command that only prints has nothing to be quiet about.
void add_quiet_options(CLI::App& app) {
  for (const char* name : {"generate", "check", "import", "simulate", "identify", "diagnose",
                           "figures", "channels", "parameters", "report"})
    app.get_subcommand(name)->add_flag_callback("--quiet", sinew::be_quiet,
                                                "Say nothing but warnings and errors");
}

/// A hand's models take seconds to compile the first time.
void show_what_is_compiled() {
  sinew::on_compiling([](const std::string& model) {
    sinew::show_progress(model.empty() ? "" : fmt::format("compiling {}", model));
  });
}

/// To people on standard error, or to a machine.
int refuse(const std::string& what, bool json) {
  json ? sinew::tell_errors(what) : sinew::complain(what);
  return wrong_usage_or_input;
}

/// Columns of a log come and go by the thousand: memory that is given back to the system after each
/// is cleared anew by it, which takes a tenth of a diagnosis. Where it cannot be set nothing is
/// lost.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, 64 << 20);
}

}  // namespace

int main(int argc, char** argv) {
  ::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of the write, which is told
  sinew::remove_when_interrupted();
  keep_freed_memory();
  sinew::diagnosis::fix_block_sizes();
  // Ceres logs to standard error what its callers judge by the fit's summary.
  FLAGS_minloglevel = google::GLOG_FATAL;
  int exit_status = 0;
  CLI::App app{"sinew: symbolic models of tendon-driven hands, emitted as real-time C"};
  app.require_subcommand(1);
  sinew::add_generate_command(app, exit_status);
  sinew::add_check_command(app, exit_status);
  sinew::add_cost_command(app, exit_status);
  sinew::add_dump_command(app, exit_status);
  sinew::add_import_command(app, exit_status);
  sinew::add_figures_command(app, exit_status);
  sinew::add_report_command(app, exit_status);
  sinew::add_parameters_command(app, exit_status);
  sinew::add_simulate_command(app, exit_status);
  sinew::add_identify_command(app, exit_status);
  sinew::add_diagnose_command(app, exit_status);
  sinew::add_channels_command(app, exit_status);
  sinew::add_effects_command(app, exit_status);
  sinew::add_manual_command(app, exit_status);
  add_quiet_options(app);
  app.set_version_flag("--version", "sinew " SINEW_VERSION);
  show_what_is_compiled();
  const bool json = sinew::wants_json(argc, argv);
  const std::vector<std::string> commands = command_names(app);
  if (argc > 1 && argv[1][0] != '-' &&
      std::find(commands.begin(), commands.end(), argv[1]) == commands.end())
    return refuse(
        fmt::format("no command is called '{}'{}; expected one of {}", sinew::message_part(argv[1]),
                    sinew::did_you_mean(argv[1], commands), sinew::listed(commands)),
        json);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, complaint;
    const int status = app.exit(error, out, complaint);
    if (status == 0) {
      sinew::tell("{}", out.str());
    } else {
      const std::string meant = sinew::meant_option(error.what(), help_of(app));
      if (json)
        sinew::tell_errors(error.what() + meant);
      else
        sinew::warn("{}", sinew::message_lines(fmt::format("{}{}\n{}", error.what(), meant,
                                                           after_first_line(complaint.str()))));
      return wrong_usage_or_input;
    }
  } catch (const std::exception& error) {
    sinew::end_if_interrupted();
    return refuse(sinew::clear_message(error), json);
  } catch (...) {
    return refuse("something that was not foreseen went wrong; please report it", json);
  }
  sinew::end_if_interrupted();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    sinew::complain("the output cannot be written");
    return wrong_usage_or_input;
  }
  return exit_status;
}
