// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/simulate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/logs/replayed_log.h"
#include "cli/models/model_folder.h"
#include "cli/runtime_folder.h"
#include "cli/simulate_report.h"
#include "cli/terminal/report_stream.h"
#include "cli/terminal/terminal.h"
#include "simulation/loop/hand_sensors.h"
#include "simulation/plant/simulate.h"
#include "simulation/plant/write_rows.h"

namespace sinew {
namespace {

struct SimulateOptions {
  std::string model, scenario, log, out, report, runtime, controller;
  std::vector<std::string> map;
  bool json = false;
};

/// Percent done, rewritten in one line of a terminal.
class RunProgress {
 public:
  explicit RunProgress(double duration) : duration_(duration), shown_(::isatty(2) != 0) {}
  ~RunProgress() {
    if (last_ >= 0) show_progress("");
  }
  void operator()(double time) {
    const int percent = static_cast<int>(100.0 * time / duration_);
    if (!shown_ || percent == last_) return;
    last_ = percent;
    show_progress(fmt::format("{:3} %", percent));
  }

 private:
  double duration_;
  bool shown_;
  int last_ = -1;
};

nlohmann::ordered_json json_of(const SimulateOptions& o, double duration, const SimulationResult& r,
                               const std::vector<diagnosis::ReplayError>& errors) {
  nlohmann::ordered_json work, deviations = nlohmann::ordered_json::array(),
                               events = nlohmann::ordered_json::array();
  for (int i = 0; i < power_count; ++i)
    work[name_of_power(i)] = r.audit.work[static_cast<std::size_t>(i)];
  for (const Event& event : r.events)
    events.push_back({{"time_s", event.time}, {"name", event.name}, {"begins", event.begins}});
  for (const diagnosis::ReplayError& e : errors)
    deviations.push_back({{"channel", e.channel},
                          {"unit", e.unit},
                          {"open_loop", e.open_loop},
                          {"window", e.window}});
  return {{"model", o.model},
          {"scenario", o.scenario},
          {"log", o.log},
          {"deviations", deviations},
          {"out", o.out},
          {"report", o.report},
          {"rows", r.rows},
          {"duration_s", duration},
          {"seconds", r.seconds},
          {"steps", r.count.steps},
          {"evaluations", r.count.evaluations},
          {"jacobians", r.count.jacobians},
          {"largest_lever_residual_m", r.audit.lever_residual},
          {"audit",
           {{"largest_energy_J", r.audit.largest_energy},
            {"energy_residual_J", r.audit.energy_residual},
            {"energy_drift_J", r.audit.energy_drift},
            {"power_residual", r.audit.power_residual},
            {"largest_friction_power_W", r.audit.largest_friction_power},
            {"work_J", work}}},
          {"event_counts", r.event_counts},
          {"events", events}};
}

/// Beside the log, where that goes to standard output.
void print_summary(const SimulateOptions& o, double duration, const SimulationResult& r,
                   const std::vector<diagnosis::ReplayError>& errors) {
  std::FILE* to = stream_of_report(o.out);
  print_to(to, "{}: {} rows over {} s written to {}\n", o.model, r.rows, duration, o.out);
  print_to(to, "  {} steps, {} evaluations, {} Jacobians in {:.3f} s: {:.1f} x real time\n",
           r.count.steps, r.count.evaluations, r.count.jacobians, r.seconds, duration / r.seconds);
  print_to(to, "  energy up to {:.4g} J; books close to {:.2g} J, powers to {:.2g}\n",
           r.audit.largest_energy, r.audit.energy_residual, r.audit.power_residual);
  for (int i = 0; i < power_count; ++i) {
    const double work = r.audit.work[static_cast<std::size_t>(i)];
    if (work != 0.0) print_to(to, "  work of {}: {:.6g} J\n", name_of_power(i), work);
  }
  for (const auto& [name, count] : r.event_counts) print_to(to, "  {}: {} times\n", name, count);
  if (!o.report.empty()) print_to(to, "  played back in {}\n", o.report);
  if (!errors.empty())
    print_to(to, "  off the logged position (rms): in open loop, within {} s\n",
             diagnosis::prediction_window);
  for (const diagnosis::ReplayError& e : errors)
    print_to(to, "    {}: {:.4g} {}, {:.4g} {}\n", e.channel, e.open_loop, e.unit, e.window,
             e.unit);
}

/// A lever, a tendon or a wrist: what its model says of its sensors. False for any other model.
bool replay_rig(const SimulateOptions& o, const Inputs& inputs) {
  const auto replay =
      o.log.empty() ? std::nullopt : replayed_rig(o.model, o.log, o.map, runtime_folder(o.runtime));
  if (!replay) return false;
  if (!o.report.empty())
    throw std::invalid_argument(
        "--report: a lever, a tendon or a wrist is not integrated, so that there is no run to play "
        "back; leave it out, or ask for the model's own page: sinew report " +
        o.model);
  RowWriter out(o.out, replay->columns, inputs);
  for (const std::vector<double>& row : replay->rows) out.write(row);
  out.finish();
  nlohmann::ordered_json deviations = nlohmann::ordered_json::array();
  for (const auto& e : replay->errors)
    deviations.push_back({{"channel", e.channel}, {"unit", e.unit}, {"sensor", e.rms}});
  if (o.json) {
    tell_json({{"model", o.model},
               {"log", o.log},
               {"out", o.out},
               {"rows", replay->rows.size()},
               {"deviations", deviations}});
    return true;
  }
  std::FILE* to = stream_of_report(o.out);
  print_to(to, "{}: {} rows written to {}\n  off the logged sensors (rms):\n", o.model,
           replay->rows.size(), o.out);
  for (const auto& e : replay->errors)
    print_to(to, "    {}: {:.4g} {}\n", e.channel, e.rms, e.unit);
  return true;
}

/// What the command reads. Throws std::runtime_error where its output cannot be written.
Inputs inputs_of_run(const SimulateOptions& o) {
  refuse_two_reports(o.out, o.json);
  if (o.report == "-")
    throw std::invalid_argument(
        "--report -: standard output is for the log or for what the command says; expected a file");
  recover_model(o.model);
  Inputs inputs;
  add_model(inputs, o.model);
  add_runtime(inputs, runtime_folder(o.runtime));
  for (const std::string& file : {o.scenario, o.log}) inputs.add(file);
  check_output_file(o.out, inputs);
  if (!o.report.empty()) check_output_file(o.report, inputs);
  return inputs;
}

void run_simulate(const SimulateOptions& o) {
  Inputs inputs = inputs_of_run(o);
  if (replay_rig(o, inputs)) return;
  const auto replayed =
      o.log.empty() ? std::nullopt : std::optional(replayed_log(o.model, o.log, o.map));
  const auto runtime = runtime_folder(o.runtime);
  Plant plant = replayed ? build_plant(o.model, replayed->replay.scenario, runtime)
                         : build_plant(o.model, o.scenario, runtime);
  for (const std::string& table : plant.scenario().tables) inputs.add(table);
  const double duration = plant.scenario().duration;
  std::optional<HandController> controller;
  if (!o.controller.empty()) controller.emplace(plant, hand_parameters_table);
  RowWriter out(o.out, output_columns(plant), inputs);
  std::optional<RunRecorder> page;
  if (!o.report.empty()) page.emplace(o.model, o.scenario.empty() ? o.log : o.scenario, plant);
  SimulationResult result;
  std::vector<std::vector<double>> rows;
  {
    RunProgress progress(duration);
    result = simulate(
        plant,
        [&](const std::vector<double>& row) {
          out.write(row);
          if (controller) controller->tick(row);
          if (page) page->add_row(row);
          if (replayed) rows.push_back(row);
        },
        [&](double time) { progress(time); },
        [&](double time, double energy, const Powers& work) {
          if (page) page->add_books(time, energy, work);
        });
  }
  if (page) {
    Outputs outputs;
    outputs.protect(inputs);
    outputs.file(o.report, page->html(result));
    out.finish();
    outputs.commit();
  } else {
    out.finish();
  }
  std::vector<diagnosis::ReplayError> errors;
  if (replayed)
    errors = diagnosis::replay_errors(replayed->replay, replayed->channels, rows, plant);
  if (replayed)
    for (const std::string& note : replayed->notes) warn("{}\n", note);
  if (o.json) {
    nlohmann::ordered_json report = json_of(o, duration, result, errors);
    if (controller) report["controller_status"] = controller->status();
    return tell_json(report);
  }
  print_summary(o, duration, result, errors);
  if (controller)
    print_to(stream_of_report(o.out), "  {}: status {:#x} (firmware/hand/hand_step.h)\n",
             o.controller, controller->status());
}

}  // namespace

void add_simulate_command(CLI::App& app, int&) {
  CLI::App* command =
      app.add_subcommand("simulate", "Integrate the emitted C of a motor, a finger or a hand");
  auto options = std::make_shared<SimulateOptions>();
  command->add_option("model", options->model, "Model folder")->required();
  CLI::Option_group* what = command->add_option_group("what happens");
  what->add_option("--scenario", options->scenario, "A scenario (docs/simulation.md)");
  what->add_option("--log", options->log,
                   "A log: its efforts act from its first state on, and its motion is compared");
  what->require_option(1);
  command->add_option("--map", options->map,
                      "Of a log: channel=column name [unit], or channel=#3 [unit]");
  command
      ->add_option("--controller", options->controller,
                   "Of a hand in the drive mode torque: hand_step, the real-time step of "
                   "firmware/hand; it follows the commands <joint>_ref")
      ->check(CLI::IsMember({"hand_step"}))
      ->needs("--scenario");
  command->add_option("--out", options->out, "CSV file of the log; - is standard output")
      ->required();
  command->add_option("--report", options->report,
                      "HTML page that plays the run back, with plots of every channel");
  command->add_option("--runtime", options->runtime, "Folder of the runtime's headers");
  command->add_flag("--json", options->json, "Report for machines");
  command->callback([options] { run_simulate(*options); });
}

}  // namespace sinew
