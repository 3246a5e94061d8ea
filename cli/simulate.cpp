// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/simulate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/runtime_folder.h"
#include "cli/terminal/terminal.h"
#include "simulation/simulate.h"
#include "simulation/write_rows.h"

namespace sinew {
namespace {

struct SimulateOptions {
  std::string model, scenario, out, runtime;
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

nlohmann::ordered_json json_of(const SimulateOptions& o, double duration,
                               const SimulationResult& r) {
  nlohmann::ordered_json work, events = nlohmann::ordered_json::array();
  for (int i = 0; i < power_count; ++i)
    work[name_of_power(i)] = r.audit.work[static_cast<std::size_t>(i)];
  for (const Event& event : r.events)
    events.push_back({{"time_s", event.time}, {"name", event.name}, {"begins", event.begins}});
  return {{"model", o.model},
          {"scenario", o.scenario},
          {"out", o.out},
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

void print_summary(const SimulateOptions& o, double duration, const SimulationResult& r) {
  tell("{}: {} rows over {} s written to {}\n", o.model, r.rows, duration, o.out);
  tell("  {} steps, {} evaluations, {} Jacobians in {:.3f} s: {:.1f} x real time\n", r.count.steps,
       r.count.evaluations, r.count.jacobians, r.seconds, duration / r.seconds);
  tell("  energy up to {:.4g} J; books close to {:.2g} J, powers to {:.2g}\n",
       r.audit.largest_energy, r.audit.energy_residual, r.audit.power_residual);
  for (int i = 0; i < power_count; ++i) {
    const double work = r.audit.work[static_cast<std::size_t>(i)];
    if (work != 0.0) tell("  work of {}: {:.6g} J\n", name_of_power(i), work);
  }
  for (const auto& [name, count] : r.event_counts) tell("  {}: {} times\n", name, count);
}

void run_simulate(const SimulateOptions& o) {
  Plant plant = build_plant(o.model, o.scenario, runtime_folder(o.runtime));
  const double duration = plant.scenario().duration;
  RowWriter out(o.out, output_columns(plant));
  SimulationResult result;
  {
    RunProgress progress(duration);
    result = simulate(
        plant, [&](const std::vector<double>& row) { out.write(row); },
        [&](double time) { progress(time); });
  }
  out.finish();
  if (o.json)
    tell_json(json_of(o, duration, result));
  else
    print_summary(o, duration, result);
}

}  // namespace

void add_simulate_command(CLI::App& app, int&) {
  CLI::App* command =
      app.add_subcommand("simulate", "Integrate the emitted C of a motor, a finger or a hand");
  auto options = std::make_shared<SimulateOptions>();
  command->add_option("model", options->model, "Model folder")->required();
  command->add_option("--scenario", options->scenario, "What happens (docs/simulation.md)")
      ->required();
  command->add_option("--out", options->out, "CSV file of the log")->required();
  command->add_option("--runtime", options->runtime, "Folder of the runtime's headers");
  command->add_flag("--json", options->json, "Report for machines");
  command->callback([options] { run_simulate(*options); });
}

}  // namespace sinew
