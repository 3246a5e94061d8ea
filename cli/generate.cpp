// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/generate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/models/change_summary.h"
#include "cli/models/model_folder.h"
#include "cli/models/model_set.h"
#include "cli/models/plausibility.h"
#include "cli/models/target_options.h"
#include "cli/terminal/terminal.h"
#include "cli/wrapper_options.h"
#include "generator/outputs/unfinished_run.h"
#include "generator/write.h"

namespace sinew {
namespace {

struct GenerateOptions {
  std::string folder, out;
  TargetOptions target;
  WrapperOptions wrappers;
  std::vector<std::string> without;
  bool json = false;
  bool runtime_parameters = false;
  bool dependents = false;
  bool strict = false;
};

void add_common_options(CLI::App& command, GenerateOptions& o) {
  command.add_option("model", o.folder, "Model folder, or a folder of model folders: all of them")
      ->required();
  command.add_option("--out", o.out,
                     "Folder of the emitted C (default: generated/<model>); of several models: the "
                     "folder of their folders");
  command.add_flag("--dependents", o.dependents, "The hands made of the model as well");
  add_target_options(command, o.target);
  add_wrapper_options(command, o.wrappers);
  command.add_option("--without", o.without, "Optimisation passes to leave out");
  command.add_flag("--runtime-parameters", o.runtime_parameters,
                   "Masses and gravity stay arguments of the dynamics");
  command.add_flag("--strict", o.strict,
                   "What is possible but not plausible (units, signs, routing) is a mistake");
  command.add_flag("--json", o.json, "Report for machines");
}

EmittedModel emit(const GenerateOptions& o, const ModelFolder& folder) {
  return assemble(folder.identity, derive_functions(folder, o.runtime_parameters),
                  o.target.target(), o.without);
}

/// As a shell takes it.
std::string word(const std::string& text) {
  const char* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./-+=:,@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// One model of a run: derived, compared with what was emitted before.
struct Derived {
  std::filesystem::path folder, out;
  EmittedModel model;
  FileSet files;
  std::vector<FunctionChange> changes;
  double seconds = 0;
  std::vector<std::string> remarks{}, warnings{};
  std::map<std::filesystem::path, FileSet> wrapped{};  ///< by folder
};

/// The folders a command is about; with --dependents also the hands made of them.
std::vector<std::filesystem::path> folders_of(const GenerateOptions& o) {
  std::vector<std::filesystem::path> folders = model_folders(o.folder);
  if (!o.dependents) return folders;
  const std::vector<std::filesystem::path> given = folders;
  for (const std::filesystem::path& folder : given)
    for (const std::filesystem::path& hand : hands_made_of(folder))
      if (std::find(folders.begin(), folders.end(), hand) == folders.end()) folders.push_back(hand);
  return folders;
}

Derived derive(const GenerateOptions& o, const std::filesystem::path& path, bool alone) {
  const auto start = std::chrono::steady_clock::now();
  const ModelFolder folder = open_model_folder(path);
  const std::vector<std::string> warnings = plausibility_warnings(folder);
  refuse_if_strict(warnings, o.strict);
  Derived derived{path, default_output(folder), emit(o, folder), {}, {},
                  0,    folder.remarks,         warnings};
  derived.files = emit_files(derived.model);
  if (!o.out.empty())
    derived.out = alone ? std::filesystem::path(o.out) : o.out / derived.out.filename();
  derived.wrapped = wrapped_files(o.wrappers, derived.model.name, derived.files);
  recover_interrupted(output_folder(derived.out).parent_path());
  derived.changes =
      function_changes(derived.out, derived.model, derived.files.at(derived.model.name + ".c"));
  derived.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return derived;
}

/// All of them before anything is written: a mistake in one leaves everything as it was.
std::vector<Derived> derive_all(const GenerateOptions& o) {
  if (!o.out.empty()) (void)output_folder(o.out);
  const std::vector<std::filesystem::path> folders = folders_of(o);
  std::vector<Derived> all;
  for (const std::filesystem::path& folder : folders) {
    show_progress(
        fmt::format("deriving {} ({} of {})", folder.string(), all.size() + 1, folders.size()));
    all.push_back(derive(o, folder, folders.size() == 1));
  }
  show_progress("");
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (all[i].out == all[j].out)
        throw std::runtime_error(fmt::format("{} and {} are both called {}; expected one of them",
                                             all[j].folder.string(), all[i].folder.string(),
                                             all[i].model.name));
  return all;
}

/// Whether what is emitted for a model comes from its files as they are now.
bool is_out_of_date(const std::filesystem::path& folder, const std::filesystem::path& beside) {
  const ModelFolder model = open_model_folder(folder);
  std::ifstream in(beside.parent_path() / model.identity.name / "manifest.json");
  const nlohmann::json manifest = nlohmann::json::parse(in, nullptr, false);
  return !manifest.is_object() || manifest.value("sha256", "") != model.identity.hash;
}

/// Hands made of a model and parts of a hand that the run left behind.
std::vector<std::filesystem::path> left_behind(const Derived& derived,
                                               const std::vector<Derived>& run) {
  std::vector<std::filesystem::path> related = hands_made_of(derived.folder);
  for (const std::filesystem::path& part : parts_of(derived.folder)) related.push_back(part);
  std::vector<std::filesystem::path> behind;
  for (const std::filesystem::path& folder : related) {
    const bool done = std::any_of(run.begin(), run.end(), [&](const Derived& d) {
      return std::filesystem::equivalent(d.folder, folder);
    });
    if (!done && is_out_of_date(folder, derived.out)) behind.push_back(folder);
  }
  return behind;
}

nlohmann::ordered_json model_json(const Derived& d, const std::vector<Derived>& run) {
  nlohmann::ordered_json report{{"model", d.model.name},
                                {"out", d.out.string()},
                                {"sha256", d.model.hash},
                                {"functions", d.model.functions.size()},
                                {"seconds", d.seconds},
                                {"changes", summary_json(d.changes)},
                                {"notes", d.remarks},
                                {"warnings", d.warnings},
                                {"left_behind", nlohmann::ordered_json::array()}};
  for (const auto& [folder, files] : d.wrapped) report["wrappers"].push_back(folder.string());
  for (const std::filesystem::path& folder : left_behind(d, run))
    report["left_behind"].push_back(folder.string());
  return report;
}

void tell_remarks(const Derived& d) {
  for (const std::string& remark : d.remarks) warn("note: {}: {}\n", d.model.name, remark);
  for (const std::string& warning : d.warnings) warn("warning: {}\n", warning);
}

void report_generated(const std::vector<Derived>& run, bool json) {
  if (json) {
    nlohmann::ordered_json models = nlohmann::ordered_json::array();
    for (const Derived& d : run) models.push_back(model_json(d, run));
    tell_json(run.size() == 1 ? models[0] : nlohmann::ordered_json{{"models", models}});
    return;
  }
  for (const Derived& d : run) {
    tell_remarks(d);
    tell("{}: {} functions written to {} in {:.2f} s\n{}", d.model.name, d.model.functions.size(),
         d.out.string(), d.seconds, summary_text(d.changes));
    for (const auto& [folder, files] : d.wrapped)
      tell("  {} files written to {}\n", files.size(), folder.string());
    for (const std::filesystem::path& folder : left_behind(d, run))
      tell("  {} has to follow: sinew generate {}\n", folder.string(), word(folder.string()));
  }
}

void run_generate(const GenerateOptions& o) {
  const std::vector<Derived> run = derive_all(o);
  Outputs outputs;
  for (const Derived& d : run) {
    add_emitted(outputs, d.out, d.files);
    for (const auto& [folder, files] : d.wrapped) outputs.into_folder(folder, files);
  }
  outputs.commit();
  report_generated(run, o.json);
}

/// The command that makes `check` with these options content.
std::string accept_command(const GenerateOptions& o) {
  std::string command = "sinew generate " + word(o.folder);
  if (!o.out.empty()) command += " --out " + word(o.out);
  command += o.target.written() + o.wrappers.written();
  if (o.wrappers.folder != WrapperOptions().folder)
    command += " --wrappers " + word(o.wrappers.folder);
  if (o.runtime_parameters) command += " --runtime-parameters";
  for (const std::string& pass : o.without) command += " --without " + pass;
  if (o.dependents) command += " --dependents";
  return command;
}

nlohmann::ordered_json check_json(const Derived& d, const std::string& diff,
                                  const std::string& accept) {
  return {{"model", d.model.name}, {"same", diff.empty()},
          {"diff", diff},          {"changes", summary_json(d.changes)},
          {"notes", d.remarks},    {"warnings", d.warnings},
          {"accept", accept}};
}

int run_check(const GenerateOptions& o) {
  const std::vector<Derived> run = derive_all(o);
  const std::string accept = accept_command(o);
  nlohmann::ordered_json models = nlohmann::ordered_json::array();
  std::string differing;
  for (const Derived& d : run) {
    std::string diff = difference(d.out, d.files);
    for (const auto& [folder, files] : d.wrapped) diff += wrapper_difference(folder, files);
    if (!o.json) tell_remarks(d);
    if (!diff.empty()) differing += (differing.empty() ? "" : ", ") + d.out.string();
    if (o.json)
      models.push_back(check_json(d, diff, accept));
    else if (diff.empty())
      tell("{}: {} is up to date\n", d.model.name, d.out.string());
    else
      tell("{}\n{}:\n{}", diff, d.model.name, summary_text(d.changes));
  }
  if (o.json)
    tell_json(run.size() == 1 ? models[0] : nlohmann::ordered_json{{"models", models}});
  else if (!differing.empty())
    tell("{} differs from what the model gives now. To accept the change:\n  {}\n", differing,
         accept);
  return differing.empty() ? 0 : 1;
}

}  // namespace

void add_generate_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("generate", "Derive a model and write its C");
  auto options = std::make_shared<GenerateOptions>();
  add_common_options(*command, *options);
  command->callback([options] { run_generate(*options); });
}

void add_check_command(CLI::App& app, int& exit_status) {
  CLI::App* command =
      app.add_subcommand("check", "Derive a model again and compare with the C that is there");
  auto options = std::make_shared<GenerateOptions>();
  add_common_options(*command, *options);
  command->callback([options, &exit_status] { exit_status = run_check(*options); });
}

}  // namespace sinew
