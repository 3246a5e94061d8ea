// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/equations.h"
#include "cli/model_report_of.h"
#include "cli/models/change_summary.h"
#include "cli/terminal/report_stream.h"
#include "cli/terminal/terminal.h"
#include "generator/emit_c.h"
#include "generator/outputs/unfinished_run.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string model, out, generated, boards = "firmware/budget.csv";
  bool json = false;
};

/// Of summary_text() what one function's line says behind its name.
std::string detail_of(const FunctionChange& change) {
  if (change.kind == FunctionChange::Kind::removed) return "the model does not give it any more";
  if (change.kind == FunctionChange::Kind::added)
    return fmt::format("{} multiplications and additions", change.operations_after.value_or(0));
  std::string text =
      change.operations_before == change.operations_after
          ? "as many operations"
          : fmt::format("{} operations, before {}", change.operations_after.value_or(0),
                        change.operations_before ? std::to_string(*change.operations_before) : "?");
  bool differs = false;
  for (const ResultChange& result : change.results) {
    const ValueChange& most = result.reference.largest > 0 ? result.reference : result.beside;
    if (most.largest == 0) continue;
    differs = true;
    text += fmt::format("; {} by {:.3g}{}", result.name, most.largest,
                        result.unit == "1" ? "" : " " + result.unit);
    if (most.relative && *most.relative < 10)
      text += fmt::format(" ({:.3g} %)", 100 * *most.relative);
  }
  return text + (differs || change.results.empty() ? "" : "; the same results");
}

std::vector<ChangedFunction> changes_of(const fs::path& before, const EmittedModel& model) {
  std::vector<ChangedFunction> changes;
  for (const FunctionChange& change : function_changes(before, model, emit_c(model))) {
    if (change.kind == FunctionChange::Kind::unchanged) continue;
    const char* word = change.kind == FunctionChange::Kind::added     ? "new"
                       : change.kind == FunctionChange::Kind::removed ? "removed"
                                                                      : "changed";
    changes.push_back({change.name, word, detail_of(change)});
  }
  return changes;
}

Inputs inputs_of(const ReportOptions& o, const fs::path& generated) {
  Inputs inputs;
  add_model(inputs, o.model);
  inputs.add(o.boards);
  std::error_code ignored;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(generated, ignored))
    inputs.add(file.path());
  return inputs;
}

void tell_written(const ReportOptions& o, const ModelReport& report, std::size_t bytes) {
  if (o.json)
    return tell_json({{"model", report.emitted.name},
                      {"kind", report.kind},
                      {"out", o.out},
                      {"bytes", bytes},
                      {"functions", report.emitted.functions.size()},
                      {"changed", report.changes.size()},
                      {"missing", report.missing}});
  std::FILE* to = stream_of_report(o.out);
  print_to(to, "{}: {} ({:.0f} kB)\n", report.emitted.name, o.out,
           static_cast<double>(bytes) / 1e3);
  for (const std::string& each : report.missing) print_to(to, "  not in it: {}\n", each);
}

void run_report(ReportOptions o) {
  recover_model(o.model);
  const ModelFolder folder = open_model_folder(o.model);
  if (o.out.empty()) o.out = folder.identity.name + ".html";
  refuse_two_reports(o.out, o.json);
  const fs::path generated = o.generated.empty() ? default_output(folder) : fs::path(o.generated);
  const Inputs inputs = inputs_of(o, generated);
  check_output_file(o.out, inputs);
  ModelReport report =
      model_report_of(folder, assemble(folder.identity, derive_functions(folder), Target{}));
  if (fs::exists(generated / "manifest.json")) {
    recover_interrupted(generated.parent_path());
    report.compared_with = generated.string();
    report.changes = changes_of(generated, report.emitted);
  }
  report.boards = read_board_costs(o.boards, report.emitted.name);
  report.boards_from = o.boards;
  report.equations = equations_html(folder);
  const std::string page = model_page(report);
  Outputs outputs;
  outputs.protect(inputs);
  outputs.file(o.out, page);
  outputs.commit();
  tell_written(o, report, page.size());
}

}  // namespace

void add_report_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("report", "Show a model on one HTML page");
  auto options = std::make_shared<ReportOptions>();
  command->add_option("model", options->model, "Model folder")->required();
  command->add_option("--out", options->out,
                      "The page (default: <model>.html); - is standard output");
  command->add_option("--generated", options->generated,
                      "Folder of the C that it is compared with (default: generated/<model>)");
  command->add_option("--boards", options->boards,
                      "Table of what functions cost on boards (scripts/accept_budget)");
  command->add_flag("--json", options->json, "Report for machines");
  command->callback([options] { run_report(*options); });
}

}  // namespace sinew
