// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/generate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/model_folder.h"
#include "generator/cost.h"
#include "generator/write.h"

namespace sinew {
namespace {

struct Options {
  std::string folder, out, scalar = "double";
  std::vector<std::string> without;
  bool json = false;
  bool runtime_parameters = false;
};

void add_common_options(CLI::App& command, Options& o) {
  command.add_option("model", o.folder, "Model folder with mechanism.toml and mass_properties.csv")
      ->required();
  command.add_option("--out", o.out, "Folder of the emitted C (default: generated/<model>)");
  command.add_option("--scalar", o.scalar, "double or float");
  command.add_option("--without", o.without, "Optimisation passes to leave out");
  command.add_flag("--runtime-parameters", o.runtime_parameters,
                   "Masses and gravity stay arguments of the dynamics");
  command.add_flag("--json", o.json, "Report for machines");
}

EmittedModel emit(const Options& o, const ModelFolder& folder) {
  return assemble(folder.identity, derive_functions(folder, o.runtime_parameters),
                  target_named(o.scalar), o.without);
}

std::filesystem::path output_folder(const Options& o, const ModelFolder& folder) {
  return o.out.empty() ? default_output(folder) : std::filesystem::path(o.out);
}

void report_generated(const EmittedModel& model, const std::filesystem::path& out, double seconds,
                      bool json) {
  if (json) {
    nlohmann::ordered_json report{{"model", model.name},
                                  {"out", out.string()},
                                  {"sha256", model.hash},
                                  {"functions", model.functions.size()},
                                  {"seconds", seconds}};
    fmt::print("{}\n", report.dump(2));
    return;
  }
  fmt::print("{}: {} functions written to {} in {:.2f} s\n", model.name, model.functions.size(),
             out.string(), seconds);
}

void run_generate(const Options& o) {
  const auto start = std::chrono::steady_clock::now();
  const ModelFolder folder = open_model_folder(o.folder);
  const EmittedModel model = emit(o, folder);
  const std::filesystem::path out = output_folder(o, folder);
  replace_folder(out, emit_files(model));
  report_generated(model, out,
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                   o.json);
}

/// As a shell takes it.
std::string word(const std::string& text) {
  const char* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./-+=:,@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// The command that makes `check` with these options content.
std::string accept_command(const Options& o) {
  std::string command = "sinew generate " + word(o.folder);
  if (!o.out.empty()) command += " --out " + word(o.out);
  if (o.scalar != "double") command += " --scalar " + o.scalar;
  for (const std::string& pass : o.without) command += " --without " + pass;
  return command;
}

int run_check(const Options& o) {
  const ModelFolder folder = open_model_folder(o.folder);
  const std::filesystem::path out = output_folder(o, folder);
  const std::string diff = difference(out, emit_files(emit(o, folder)));
  const std::string accept = accept_command(o);
  if (o.json) {
    nlohmann::ordered_json report{{"model", folder.identity.name},
                                  {"same", diff.empty()},
                                  {"diff", diff},
                                  {"accept", accept}};
    fmt::print("{}\n", report.dump(2));
  } else if (diff.empty()) {
    fmt::print("{}: {} is up to date\n", folder.identity.name, out.string());
  } else {
    fmt::print("{}\n{} differs from what the model gives now. To accept the change:\n  {}\n", diff,
               out.string(), accept);
  }
  return diff.empty() ? 0 : 1;
}

}  // namespace

void add_generate_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("generate", "Derive a model and write its C");
  auto options = std::make_shared<Options>();
  add_common_options(*command, *options);
  command->callback([options] { run_generate(*options); });
}

void add_check_command(CLI::App& app, int& exit_status) {
  CLI::App* command =
      app.add_subcommand("check", "Derive a model again and compare with the C that is there");
  auto options = std::make_shared<Options>();
  add_common_options(*command, *options);
  command->callback([options, &exit_status] { exit_status = run_check(*options); });
}

}  // namespace sinew
