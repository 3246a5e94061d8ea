// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/identify.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/identify_experiments.h"
#include "cli/identify_logs.h"
#include "cli/models/model_folder.h"
#include "cli/terminal/report_stream.h"
#include "cli/terminal/terminal.h"
#include "generator/outputs/unfinished_run.h"
#include "generator/write.h"
#include "identification/logs/model_channels.h"
#include "symbolic/parts/part.h"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

struct IdentifyOptions {
  std::string model, experiment, out, emit, tables;
  std::vector<std::string> logs, map;
  bool repair = false, json = false;
};

constexpr const char* log_experiments[]{"friction", "inertia", "ripple", "lever"};

std::vector<ChannelSpec> channels_of(const std::string& experiment) {
  if (experiment == "lever") return lever_channels();
  std::vector<ChannelSpec> channels = rotary_drive_channels();
  if (experiment == "ripple") {
    // The controller's torque before the feedforward: what a compensation takes from it.
    ChannelSpec controller;
    controller.name = "tau_c";
    controller.unit = "N*m";
    channels.push_back(controller);
  }
  return channels;
}

bool names_one_of(const std::vector<ChannelSpec>& channels, const std::string& line) {
  return std::any_of(channels.begin(), channels.end(), [&](const ChannelSpec& channel) {
    return line.starts_with(channel.name + "=");
  });
}

/// What --map and the model's channels.toml say. That file is of all logs of the model: its lines
/// about channels that only another experiment has are of no concern here.
std::vector<std::string> maps_of(const IdentifyOptions& o) {
  std::vector<std::string> maps = mapped_channels(o.model, o.map);
  const auto of_others = [&](const std::string& line) {
    if (names_one_of(channels_of(o.experiment), line)) return false;
    return std::any_of(std::begin(log_experiments), std::end(log_experiments),
                       [&](const char* other) { return names_one_of(channels_of(other), line); });
  };
  maps.erase(std::remove_if(maps.begin() + static_cast<std::ptrdiff_t>(o.map.size()), maps.end(),
                            of_others),
             maps.end());
  return maps;
}

const LeverParameters* lever_of(const Part& part) {
  if (const auto* tendon = std::get_if<TendonWithLever>(&part.parameters)) return &tendon->lever;
  return std::get_if<LeverParameters>(&part.parameters);
}

bool has_guiding(const Part& part) {
  return std::holds_alternative<FittedGuiding>(part.parameters) ||
         std::holds_alternative<CapstanGuiding>(part.parameters);
}

void require(bool fits, const IdentifyOptions& o, const char* expected) {
  if (!fits)
    throw std::runtime_error(
        fmt::format("{}: describes another part; expected {} for the "
                    "experiment {}",
                    o.model, expected, o.experiment));
}

IdentifyReport identify(const IdentifyOptions& o, std::vector<Log>& logs) {
  const Part part = read_part(o.model);
  const auto* motor = std::get_if<MotorParameters>(&part.parameters);
  const LeverParameters* lever = lever_of(part);
  if (o.experiment == "guiding") {
    require(has_guiding(part), o, "a tendon's guiding");
    return report_guiding(o.logs, !o.tables.empty());
  }
  if (o.experiment == "lever")
    require(lever != nullptr, o, "a lever");
  else
    require(motor != nullptr, o, "a motor");
  logs = read_experiment_logs(o.logs, maps_of(o), channels_of(o.experiment), o.repair);
  if (o.experiment == "lever") return report_lever(logs, *lever, !o.emit.empty());
  if (o.experiment == "friction") return report_friction(logs, *motor);
  return o.experiment == "inertia" ? report_inertia(logs, *motor) : report_ripple(logs, *motor);
}

Json sources_of(const std::vector<Log>& logs) {
  Json sources = Json::array();
  for (const Log& log : logs) {
    Json faults = Json::array();
    for (const DataFault& fault : log.faults) faults.push_back(message(fault));
    sources.push_back(
        {{"file", log.file}, {"sha256", log.sha256}, {"rows", log.rows}, {"faults", faults}});
  }
  return sources;
}

void print_value(std::FILE* to, const std::string& name, const Json& value) {
  if (value.is_object() && value.contains("standard_error"))
    print_to(to, "{}: {:.6g} +- {:.2g}\n", name, value["value"].get<double>(),
             value["standard_error"].get<double>());
  else if (value.is_object())
    for (const auto& [inner, each] : value.items()) print_value(to, name + "." + inner, each);
  else if (value.is_array() && !value.empty() && value.front().is_object())
    for (std::size_t i = 0; i < value.size(); ++i)
      print_value(to, fmt::format("{}[{}]", name, i), value[i]);
  else
    print_to(to, "{}: {}\n", name, value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// What the command reads. Throws std::runtime_error where an output cannot be written.
Inputs inputs_of_experiment(const IdentifyOptions& o) {
  refuse_two_reports(o.out, o.json);
  recover_model(o.model);
  Inputs inputs;
  add_model(inputs, o.model);
  for (const std::string& log : o.logs) inputs.add(log);
  check_output_file(o.out, inputs);
  for (const std::string& folder : {o.emit, o.tables})
    if (!folder.empty()) recover_interrupted(output_folder(folder));
  return inputs;
}

void write_identified(const IdentifyOptions& o, Inputs inputs, const IdentifyReport& report,
                      const std::string& text) {
  Outputs outputs;
  outputs.protect(std::move(inputs));
  outputs.file(o.out, text);
  if (!report.emitted.empty()) add_emitted(outputs, o.emit, report.emitted);
  if (!report.tables.empty()) outputs.into_folder(o.tables, report.tables);
  outputs.commit();
}

void print_report(const IdentifyOptions& o, const IdentifyReport& report) {
  std::FILE* to = stream_of_report(o.out);
  for (const auto& [name, value] : report.results.items()) print_value(to, name, value);
  for (const std::string& text : report.missing) print_to(to, "not identified: {}\n", text);
  print_to(to, "written to {}\n", o.out);
}

int run_identify(const IdentifyOptions& o) {
  Inputs inputs = inputs_of_experiment(o);
  std::vector<Log> logs;
  const IdentifyReport report = identify(o, logs);
  const Json whole{
      {"model", o.model},          {"experiment", o.experiment}, {"identified", report.identified},
      {"results", report.results}, {"missing", report.missing},  {"logs", sources_of(logs)}};
  write_identified(o, std::move(inputs), report, json_text(whole));
  if (o.json)
    tell_json(whole);
  else
    print_report(o, report);
  return report.identified ? 0 : 1;
}

}  // namespace

void add_identify_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "identify", "Friction, inertia, ripple, the lever's sensor or guiding friction from logs");
  auto options = std::make_shared<IdentifyOptions>();
  command->add_option("model", options->model, "Model folder of the part")->required();
  command
      ->add_option("--experiment", options->experiment,
                   "friction, inertia, ripple, lever or guiding")
      ->required()
      ->check(CLI::IsMember({"friction", "inertia", "ripple", "lever", "guiding"}));
  command->add_option("--log", options->logs, "CSV logs or tables (docs/identify.md)")->required();
  command->add_option("--map", options->map, "channel=column [unit]");
  command->add_option("--out", options->out, "JSON file of the results; - is standard output")
      ->required();
  command->add_option("--emit", options->emit, "lever: folder for the C of the calibration");
  command->add_option("--tables", options->tables,
                      "guiding: folder for the designers' tables and plots");
  command->add_flag("--repair", options->repair,
                    "Take logs with cells that are no numbers or rows out of time, repaired");
  command->add_flag("--json", options->json, "Report for machines");
  command->callback([options, &exit_status] { exit_status = run_identify(*options); });
}

}  // namespace sinew
