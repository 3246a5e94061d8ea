// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/identify.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/identify_experiments.h"
#include "cli/identify_logs.h"
#include "cli/terminal/terminal.h"
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
    return report_guiding(o.logs, o.tables);
  }
  if (o.experiment == "lever")
    require(lever != nullptr, o, "a lever");
  else
    require(motor != nullptr, o, "a motor");
  logs = read_experiment_logs(o.logs, maps_of(o), channels_of(o.experiment), o.repair);
  if (o.experiment == "lever") return report_lever(logs, *lever, o.emit);
  if (o.experiment == "friction") return report_friction(logs, *motor);
  return o.experiment == "inertia" ? report_inertia(logs, *motor) : report_ripple(logs, *motor);
}

/// The file appears whole or not at all.
void write_whole(const std::string& file, const std::string& text) {
  const std::string partial = fmt::format("{}.part-{}", file, ::getpid());
  std::ofstream out(partial, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(partial, file, error);
  if (!out || error) {
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw std::runtime_error(file + ": cannot be written");
  }
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

void print_value(const std::string& name, const Json& value) {
  if (value.is_object() && value.contains("standard_error"))
    tell("{}: {:.6g} +- {:.2g}\n", name, value["value"].get<double>(),
         value["standard_error"].get<double>());
  else if (value.is_object())
    for (const auto& [inner, each] : value.items()) print_value(name + "." + inner, each);
  else if (value.is_array() && !value.empty() && value.front().is_object())
    for (std::size_t i = 0; i < value.size(); ++i)
      print_value(fmt::format("{}[{}]", name, i), value[i]);
  else
    tell("{}: {}\n", name, value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

int run_identify(const IdentifyOptions& o) {
  std::vector<Log> logs;
  const IdentifyReport report = identify(o, logs);
  const Json whole{
      {"model", o.model},          {"experiment", o.experiment}, {"identified", report.identified},
      {"results", report.results}, {"missing", report.missing},  {"logs", sources_of(logs)}};
  write_whole(o.out, json_text(whole));
  if (o.json) {
    tell_json(whole);
  } else {
    for (const auto& [name, value] : report.results.items()) print_value(name, value);
    for (const std::string& text : report.missing) tell("not identified: {}\n", text);
    tell("written to {}\n", o.out);
  }
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
  command->add_option("--out", options->out, "JSON file of the results")->required();
  command->add_option("--emit", options->emit, "lever: folder for the C of the calibration");
  command->add_option("--tables", options->tables,
                      "guiding: folder for the designers' tables and plots");
  command->add_flag("--repair", options->repair,
                    "Take logs with cells that are no numbers or rows out of time, repaired");
  command->add_flag("--json", options->json, "Report for machines");
  command->callback([options, &exit_status] { exit_status = run_identify(*options); });
}

}  // namespace sinew
