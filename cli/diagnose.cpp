// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diagnose.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>

#include "cli/diagnose_fleet.h"
#include "cli/logs/diagnose_rig.h"
#include "cli/logs/driven_request.h"
#include "cli/models/model_folder.h"
#include "cli/runtime_folder.h"
#include "cli/terminal/terminal.h"
#include "generator/outputs/unfinished_run.h"
#include "generator/write.h"
#include "identification/adoption/diagnose.h"
#include "identification/adoption/ended_early.h"
#include "identification/adoption/held_out_judgement.h"
#include "identification/logs/model_channels.h"
#include "identification/report/findings_json.h"
#include "identification/report/html.h"
#include "identification/report/text.h"
#include "identification/report/verdict_text.h"
#include "identification/subjects/driven_channels.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/hand/hand_mechanism.h"
#include "symbolic/model/read_mechanism.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;
using diagnosis::DiagnoseRequest;
using diagnosis::Diagnosis;

struct DiagnoseOptions {
  std::string folder, out, runtime;
  std::vector<std::string> logs, holdout, map, constants, conditions;
  std::string summarise;
  std::vector<std::string> sums, sums_holdout, reference;
  double band = 0.0, material = diagnosis::Settings{}.material_share;
  unsigned seed = 1;
  bool dry_run = false, json = false, quick = false;
};

/// One line that is written over, on a terminal only.
class Progress {
 public:
  explicit Progress(bool wanted) : shown_(wanted && ::isatty(STDERR_FILENO)) {}
  ~Progress() {
    if (shown_) show_progress("");
  }
  void operator()(const std::string& step, double share) const {
    if (shown_) show_progress(fmt::format("[{:3.0f} %] {}", 100.0 * share, step));
  }

 private:
  bool shown_;
};

/// What does not depend on the kind of model.
template <class Request>
void set_common(const DiagnoseOptions& o, const ModelFolder& folder, Request& request) {
  request.name = folder.identity.name;
  request.description = folder.identity.description;
  request.hash = folder.identity.hash;
  request.runtime = runtime_folder(o.runtime);
  request.identified = folder.identified;
  request.logs = o.logs;
  request.holdout = o.holdout;
  request.map = o.map;
  request.settings.edge_s = diagnosis::driven_edge;
  const double band = o.quick ? kFirstLookBand : diagnosis::driven_band;
  request.settings.band_hz = o.band > 0.0 ? o.band : band;
  request.settings.first_look = o.quick;
  request.settings.seed = o.seed;
  request.settings.material_share = o.material;
}

DiagnoseRequest request_for(const DiagnoseOptions& o, const ModelFolder& folder) {
  DiagnoseRequest request;
  set_common(o, folder, request);
  request.torque_constants = torque_constants(o.folder, o.constants);
  for (const std::string& text : o.conditions) request.payloads.push_back(carried_payload(text));
  std::vector<std::string> files = o.logs;
  files.insert(files.end(), o.holdout.begin(), o.holdout.end());
  check_payloads(request.payloads, files);
  set_driven_model(folder, request);
  return request;
}

/// What was learnt of joints that these logs do not move stays as it was.
void keep_what_was_left_out(const Identified& known, const Identified& taken,
                            Identified& extended) {
  if (known.effects.size() == taken.effects.size()) return;
  for (const IdentifiedEffect& entry : known.effects) {
    const auto is_same = [&](const IdentifiedEffect& e) {
      return e.effect == entry.effect && e.place == entry.place;
    };
    if (std::none_of(taken.effects.begin(), taken.effects.end(), is_same))
      extended.effects.push_back(entry);
  }
}

Inputs inputs_of(const DiagnoseOptions& o) {
  Inputs inputs;
  add_model(inputs, o.folder);
  add_runtime(inputs, runtime_folder(o.runtime));
  for (const auto& files : {o.logs, o.holdout})
    for (const std::string& file : files) inputs.add(file);
  return inputs;
}

/// Before the long calculation. Throws std::runtime_error.
void check_outputs(const DiagnoseOptions& o) {
  const fs::path out = output_folder(o.out);
  std::error_code ignored;
  if (fs::equivalent(out, o.folder, ignored))
    throw std::runtime_error(o.out +
                             ": is the model's folder; expected another one for the report");
  recover_interrupted(out);
  const Inputs inputs = inputs_of(o);
  for (const char* name : {"report.html", "findings.json", "identified.toml"})
    inputs.refuse(out / name);
}

/// The C of the model with what it has learnt. What cannot be generated is not adopted, and the
/// report says why.
FileSet generated_c(const DiagnoseOptions& o, Diagnosis& diagnosis) {
  FileSet files;
  if (!diagnosis.findings.extension.adopted) return files;
  ModelFolder folder = open_model_folder(o.folder);
  folder.identified = diagnosis.extended;
  Mechanism* mechanism = std::get_if<Mechanism>(&folder.model);
  if (mechanism) *mechanism = read_mechanism(o.folder);
  const std::string failed = diagnosis::why_ended([&] {
    if (mechanism) *mechanism = with_identified(*mechanism, diagnosis.extended);
    files = emit_files(assemble(folder.identity, derive_functions(folder), Target{}));
  });
  if (!failed.empty())
    diagnosis::withhold("the extended model cannot be generated: " + failed,
                        diagnosis.findings.extension);
  return files;
}

void write_results(const DiagnoseOptions& o, Diagnosis& diagnosis) {
  auto& extension = diagnosis.findings.extension;
  extension.dry_run = o.dry_run;
  std::map<std::string, std::string> files = diagnosis.experiments;
  const FileSet generated = generated_c(o, diagnosis);
  diagnosis.findings.next_step = diagnosis::next_step(diagnosis.findings);
  Outputs outputs;  // the model first: its folder keeps the journal
  if (extension.adopted) {
    files["identified.toml"] = identified_text(diagnosis.extended);
    if (!o.dry_run) {
      outputs.into_folder(o.folder, {{"identified.toml", files["identified.toml"]}});
      extension.model_folder = o.folder;
    }
  }
  files["findings.json"] = findings_json(diagnosis.findings);
  files["report.html"] = report_html(diagnosis.findings);
  outputs.protect(inputs_of(o));
  outputs.into_folder(o.out, files);
  if (extension.adopted)
    add_emitted(outputs, fs::path(o.out) / "generated" / diagnosis.findings.model, generated);
  outputs.commit();
}

int run(DiagnoseOptions o) {
  check_outputs(o);
  const ModelFolder folder = open_model_folder(o.folder);
  o.map = mapped_channels(o.folder, o.map);
  const Progress progress(!o.json);
  const auto told = [&](const std::string& step, double share) { progress(step, share); };
  Diagnosis diagnosis;
  if (auto rig = rig_request(folder, o.logs, o.holdout, o.map)) {
    set_common(o, folder, *rig);
    rig->progress = told;
    diagnosis = diagnose_observed(*rig);
  } else {
    DiagnoseRequest request = request_for(o, folder);
    request.progress = told;
    diagnosis = diagnose(request);
    keep_what_was_left_out(folder.identified, request.identified, diagnosis.extended);
  }
  write_results(o, diagnosis);
  if (o.json)
    tell("{}", findings_json(diagnosis.findings));
  else
    tell("{}\nReport: {}\n", report_text(diagnosis.findings),
         (fs::path(o.out) / "report.html").string());
  return diagnosis.findings.verdict.nothing_beyond_noise() ? 0 : 1;
}

/// The log to sum is prepared as a held-out log is: the reference logs decide the columns.
DiagnoseOptions with_reference(DiagnoseOptions o) {
  o.holdout = o.logs;
  if (!o.reference.empty()) o.logs = o.reference;
  return o;
}

int run_fleet(const DiagnoseOptions& given) {
  DiagnoseOptions o = with_reference(given);
  const ModelFolder folder = open_model_folder(o.folder);
  o.map = mapped_channels(o.folder, o.map);
  if (rig_request(folder, o.logs, o.holdout, o.map))
    throw std::runtime_error(o.folder +
                             ": sums are written of a motor, a joint or an arm, whose efforts are "
                             "logged; diagnose this model with its logs");
  const DiagnoseRequest request = request_for(o, folder);
  if (given.sums.empty()) return run_summarise(request, o.summarise, inputs_of(o), o.json);
  return run_sums(request, o.sums, o.sums_holdout, o.json);
}

/// What the parser cannot say of options that go together.
void check_options(const DiagnoseOptions& o) {
  if (!o.sums.empty()) {
    if (o.reference.empty()) throw CLI::RequiredError("--reference");
    return;
  }
  if (o.logs.empty()) throw CLI::RequiredError("--log");
  if (o.summarise.empty() && !o.reference.empty())
    throw CLI::RequiresError("--reference", "--summarise or --sums");
  if (!o.summarise.empty() && o.logs.size() != 1)
    throw CLI::ValidationError("--log", "--summarise takes one log at a time");
  if (o.summarise.empty() && o.out.empty()) throw CLI::RequiredError("--out");
}

void add_fleet_options(CLI::App* command, DiagnoseOptions& o) {
  CLI::Option* summarise = command->add_option(
      "--summarise", o.summarise, "Write the log's sums to this file instead (docs/fleets.md)");
  CLI::Option* sums =
      command->add_option("--sums", o.sums, "Files of sums to learn from, instead of logs");
  command->add_option("--sums-holdout", o.sums_holdout, "Files of sums to judge on")->needs(sums);
  command->add_option("--reference", o.reference,
                      "Logs whose ranges decide what all sums are made of");
  for (const char* other : {"--holdout", "--out", "--dry-run"}) {
    summarise->excludes(other);
    sums->excludes(other);
  }
  sums->excludes("--log");
  sums->excludes(summarise);
}

}  // namespace

void add_diagnose_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "diagnose", "Show what a model gets wrong on measured logs, name the cause, extend it");
  auto o = std::make_shared<DiagnoseOptions>();
  command->add_option("model", o->folder, "Model folder")->required();
  command->add_option("--log", o->logs, "Logs to learn from (CSV)");
  command->add_option("--holdout", o->holdout, "Logs to judge on, not learnt from");
  command->add_option("--out", o->out, "Folder for report.html and findings.json");
  command->add_option("--map", o->map, "channel=column name [unit], or channel=#3 [unit]");
  command->add_option("--torque-constant", o->constants,
                      "joint=VALUE: effort of 1 A at the joint [N*m/A, N/A], of logged currents");
  command->add_option("--condition", o->conditions,
                      "[LOG:]payload[@LINK]=MASS kg [at X, Y, Z m]: a load that a log carried");
  command->add_option("--band", o->band, "Highest frequency looked at [Hz]")
      ->check([](const std::string& text) {
        double hertz = 0.0;
        std::istringstream in(text);
        return in >> hertz && in.eof() && hertz > 0.0
                   ? std::string()
                   : "expected a frequency above 0 Hz, got '" + text + "'";
      });
  command
      ->add_option("--material", o->material,
                   "Share of a channel's rms: errors below are not told (0.001)")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--seed", o->seed, "Of the intervals");
  command->add_option("--runtime", o->runtime, "Folder of the runtime's headers");
  command->add_flag("--quick", o->quick,
                    "A first look at a part of the samples, up to 25 Hz: adopts nothing");
  command->add_flag("--dry-run", o->dry_run, "Leave the model as it is");
  command->add_flag("--json", o->json, "findings.json on standard output");
  add_fleet_options(command, *o);
  command->callback([o, &exit_status] {
    check_options(*o);
    exit_status = o->sums.empty() && o->summarise.empty() ? run(*o) : run_fleet(*o);
  });
}

}  // namespace sinew
