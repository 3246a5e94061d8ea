// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diagnose.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>
#include <sstream>

#include "cli/diagnose_rig.h"
#include "cli/learnt_model.h"
#include "cli/model_folder.h"
#include "cli/runtime_folder.h"
#include "cli/terminal/terminal.h"
#include "generator/write.h"
#include "identification/adoption/diagnose.h"
#include "identification/logs/model_channels.h"
#include "identification/report/findings_json.h"
#include "identification/report/report_html.h"
#include "identification/report/report_text.h"
#include "identification/report/verdict_text.h"
#include "identification/subjects/driven_channels.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/files/put_files.h"
#include "symbolic/hand/hand_mechanism.h"
#include "symbolic/model/read_mechanism.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;
using diagnosis::DiagnoseRequest;
using diagnosis::Diagnosis;

struct DiagnoseOptions {
  std::string folder, out, runtime;
  std::vector<std::string> logs, holdout, map;
  double band = 0.0;
  unsigned seed = 1;
  bool dry_run = false, json = false;
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

DriveLimits limits_of(const DrivenJoint& joint) {
  DriveLimits limits;
  limits.inertia = joint.armature;
  limits.friction = joint.friction;
  return limits;
}

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
  request.settings.band_hz = o.band > 0.0 ? o.band : diagnosis::driven_band;
  request.settings.seed = o.seed;
}

/// Joints by their own efforts, or by the forces of their tendons: what the first log has.
void set_robot(const DiagnoseOptions& o, const Mechanism& mechanism, DiagnoseRequest& request) {
  using diagnosis::LoggedEfforts;
  request.mechanism = mechanism;
  const LoggedEfforts logged = diagnosis::logged_efforts(mechanism, o.logs.front(), o.map);
  if (logged == LoggedEfforts::at_joints) {
    request.kind = "robot";
    request.model = driven_model(mechanism, emitted_cost);
    request.channels = [mechanism, map = o.map](const std::string& file) {
      return diagnosis::robot_log_channels(mechanism, file, map);
    };
    return;
  }
  request.kind = "tendon-driven joints";
  const std::optional<MotorParameters> motor =
      logged == LoggedEfforts::tendon_forces_and_motors ? motor_beside(o.folder) : std::nullopt;
  request.model = tendon_driven_model(mechanism, motor, emitted_cost);
  request.channels = [mechanism, motors = motor.has_value()](const std::string&) {
    return diagnosis::tendon_log_channels(mechanism, diagnosis::tendon_numbers(mechanism), motors);
  };
}

/// All fingers of a hand by the forces of their tendons, the palm held.
void set_hand(const Hand& hand, const Identified& identified, DiagnoseRequest& request) {
  const HeldHand held = held_hand(hand);
  request.mechanism = with_identified(held.mechanism, identified);
  request.kind = "hand with a held palm";
  request.model = tendon_driven_model(*request.mechanism, {}, emitted_cost);
  std::vector<int> numbers;
  for (const int channel : held.channels) numbers.push_back(channel + 1);
  request.channels = [held, numbers](const std::string&) {
    diagnosis::DrivenChannels channels =
        diagnosis::tendon_log_channels(held.mechanism, numbers, false);
    for (std::size_t i = 0; i < held.coordinates.size(); ++i)
      channels.specs[i].name = channels.positions[i] = held.coordinates[i];
    return channels;
  };
}

DiagnoseRequest request_for(const DiagnoseOptions& o, const ModelFolder& folder) {
  DiagnoseRequest request;
  set_common(o, folder, request);
  if (const Mechanism* mechanism = std::get_if<Mechanism>(&folder.model)) {
    set_robot(o, *mechanism, request);
    return request;
  }
  if (const Hand* hand = std::get_if<Hand>(&folder.model)) {
    set_hand(*hand, folder.identified, request);
    return request;
  }
  const Part* part = std::get_if<Part>(&folder.model);
  const MotorParameters* motor = part ? std::get_if<MotorParameters>(&part->parameters) : nullptr;
  if (!motor)
    throw std::runtime_error(
        o.folder +
        ": diagnose works on a mechanism of joints, a hand, a motor, a lever, a tendon or a wrist; "
        "this model is none of them");
  request.kind = "rotary drive";
  request.model = driven_model(*motor, part->name);
  request.channels = [limits = limits_of(request.model.joints.front())](const std::string&) {
    return diagnosis::drive_log_channels(true, limits);
  };
  return request;
}

/// The model's folder with what it has learnt, and its C, as they would be.
FileSet extended_c(const DiagnoseOptions& o, const Diagnosis& diagnosis) {
  ModelFolder folder = open_model_folder(o.folder);
  folder.identified = diagnosis.extended;
  if (Mechanism* mechanism = std::get_if<Mechanism>(&folder.model))
    *mechanism = with_identified(read_mechanism(o.folder), diagnosis.extended);
  return emit_files(assemble(folder.identity, derive_functions(folder), Target{}));
}

void write_results(const DiagnoseOptions& o, Diagnosis& diagnosis) {
  auto& extension = diagnosis.findings.extension;
  extension.dry_run = o.dry_run;
  diagnosis.findings.next_step = diagnosis::next_step(diagnosis.findings);
  std::map<std::string, std::string> files = diagnosis.experiments;
  const FileSet generated = extension.adopted ? extended_c(o, diagnosis) : FileSet{};
  if (extension.adopted) {
    files["identified.toml"] = identified_text(diagnosis.extended);
    if (!o.dry_run) {
      put_files(o.folder, {{"identified.toml", files["identified.toml"]}}, true);
      extension.model_folder = o.folder;
    }
  }
  files["findings.json"] = findings_json(diagnosis.findings);
  files["report.html"] = report_html(diagnosis.findings);
  put_files(o.out, files, true);
  if (extension.adopted)
    replace_folder(fs::path(o.out) / "generated" / diagnosis.findings.model, generated);
}

int run(DiagnoseOptions o) {
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
  }
  write_results(o, diagnosis);
  if (o.json)
    tell("{}", findings_json(diagnosis.findings));
  else
    tell("{}\nReport: {}\n", report_text(diagnosis.findings),
         (fs::path(o.out) / "report.html").string());
  return diagnosis.findings.verdict.nothing_beyond_noise() ? 0 : 1;
}

}  // namespace

void add_diagnose_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "diagnose", "Show what a model gets wrong on measured logs, name the cause, extend it");
  auto o = std::make_shared<DiagnoseOptions>();
  command->add_option("model", o->folder, "Model folder")->required();
  command->add_option("--log", o->logs, "Logs to learn from (CSV)")->required();
  command->add_option("--holdout", o->holdout, "Logs to judge on, not learnt from");
  command->add_option("--out", o->out, "Folder for report.html and findings.json")->required();
  command->add_option("--map", o->map, "channel=column name [unit], or channel=#3 [unit]");
  command->add_option("--band", o->band, "Highest frequency looked at [Hz]")
      ->check([](const std::string& text) {
        double hertz = 0.0;
        std::istringstream in(text);
        return in >> hertz && in.eof() && hertz > 0.0
                   ? std::string()
                   : "expected a frequency above 0 Hz, got '" + text + "'";
      });
  command->add_option("--seed", o->seed, "Of the surrogates and intervals");
  command->add_option("--runtime", o->runtime, "Folder of the runtime's headers");
  command->add_flag("--dry-run", o->dry_run, "Leave the model as it is");
  command->add_flag("--json", o->json, "findings.json on standard output");
  command->callback([o, &exit_status] { exit_status = run(*o); });
}

}  // namespace sinew
