// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/identify.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "generator/assemble.h"
#include "generator/write.h"
#include "identification/friction_curve.h"
#include "identification/inertia_impulse.h"
#include "identification/lever_calibration.h"
#include "identification/read_csv.h"
#include "identification/ripple_fit.h"
#include "symbolic/part.h"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string model, experiment, out, emit;
  std::vector<std::string> logs, map;
  bool json = false;
};

struct Report {
  bool identified = false;
  Json results;
  std::vector<std::string> missing;
};

Json json_of(const Estimate& e) {
  return {{"value", e.value},
          {"standard_error", e.standard_error},
          {"interval_95", Json::array({e.low, e.high})}};
}

std::vector<Log> read_logs(const Options& o, const std::vector<ChannelSpec>& channels) {
  ReadOptions options;
  options.map = o.map;
  options.check_consistency = false;  // an experiment excites what a log of work does not
  std::vector<Log> logs;
  for (const std::string& file : o.logs) logs.push_back(read_csv(file, channels, options));
  return logs;
}

std::vector<DriveStretch> all_stretches(const std::vector<Log>& logs) {
  std::vector<DriveStretch> all;
  for (const Log& log : logs)
    for (DriveStretch& stretch : drive_stretches(log)) all.push_back(std::move(stretch));
  return all;
}

Report friction(const std::vector<Log>& logs, const MotorParameters& motor) {
  const FrictionCurve curve = identify_friction(all_stretches(logs), motor.gear_ratio);
  Json points = Json::array();
  for (const FrictionPoint& p : curve.points)
    points.push_back({{"velocity_rad_s", p.velocity},
                      {"torque_Nm", p.torque},
                      {"lowest_Nm", p.low},
                      {"highest_Nm", p.high},
                      {"motor_periods", p.periods},
                      {"deviation_Nm", p.deviation}});
  Json results{{"points", points}};
  if (curve.gamma1.value > 0.0) {
    results["gamma1_s_per_rad"] = json_of(curve.gamma1);
    results["gamma2_Nm"] = json_of(curve.gamma2);
    results["gamma3_Nms_per_rad"] = json_of(curve.gamma3);
    results["plateau_Nm"] = json_of(curve.plateau);
    results["residual_Nm"] = curve.residual;
  }
  return {curve.identified, results, curve.missing};
}

Report inertia(const std::vector<Log>& logs, const MotorParameters& motor) {
  const InertiaResult r = identify_inertia(all_stretches(logs), motor);
  return {r.identified,
          {{"inertia_kgm2", json_of(r.inertia)},
           {"without_friction_kgm2", json_of(r.without_friction)},
           {"bias_without_friction", r.bias},
           {"residual_Nm", r.residual},
           {"residual_without_friction_Nm", r.residual_without}},
          r.missing};
}

Report ripple(const std::vector<Log>& logs, const MotorParameters& motor) {
  const RippleResult r = identify_ripple(all_stretches(logs), motor);
  Json ripples = Json::array(), velocity = Json::array();
  for (const FittedRipple& f : r.ripples)
    ripples.push_back({{"side", f.order.input ? "input" : "output"},
                       {"order", f.order.order},
                       {"amplitude_Nm", json_of(f.amplitude)},
                       {"phase_rad", json_of(f.phase)}});
  for (const Log& log : logs)
    velocity.push_back(
        {{"log", log.file},
         {"amplitude_rad_s",
          velocity_ripple_at_motor_order(drive_stretches(log, 2 * log.period), motor.gear_ratio)}});
  return {r.missing.empty() || !r.ripples.empty(),
          {{"ripple", ripples}, {"residual_Nm", r.residual}, {"velocity_at_motor_order", velocity}},
          r.missing};
}

Report lever(const std::vector<Log>& logs, const Options& o) {
  const LeverCalibrationResult r = calibrate_lever(logs);
  const LeverCalibration& c = r.calibration;
  if (r.identified && !o.emit.empty())
    replace_folder(o.emit, emit_files(assemble({"lever_calibration",
                                                "Lever sensor: length, force and stiffness from "
                                                "counts",
                                                logs.front().sha256,
                                                {}},
                                               {lever_calibrated_state(c)}, {})));
  return {r.identified,
          {{"centre_counts", c.centre},
           {"half_range_counts", c.half_range},
           {"force_N", c.force},
           {"length_m", c.length},
           {"force_validation_rms_N", r.force.validation_rms},
           {"length_validation_rms_m", r.length.validation_rms},
           {"largest_force_error_N", r.largest_force_error},
           {"largest_length_error_m", r.largest_length_error},
           {"stiffness_mismatch", r.stiffness_mismatch},
           {"hysteresis_N", r.hysteresis},
           {"hysteresis_at_N", r.hysteresis_at}},
          r.missing};
}

Report identify(const Options& o, std::vector<Log>& logs) {
  const Part part = read_part(o.model);
  if (o.experiment == "lever") {
    logs = read_logs(o, lever_channels());
    return lever(logs, o);
  }
  const auto* motor = std::get_if<MotorParameters>(&part.parameters);
  if (!motor)
    throw std::runtime_error(o.model + ": describes no motor; expected one for the experiment " +
                             o.experiment);
  logs = read_logs(o, rotary_drive_channels());
  if (o.experiment == "friction") return friction(logs, *motor);
  return o.experiment == "inertia" ? inertia(logs, *motor) : ripple(logs, *motor);
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

int run_identify(const Options& o) {
  std::vector<Log> logs;
  const Report report = identify(o, logs);
  Json sources = Json::array();
  for (const Log& log : logs) {
    Json faults = Json::array();
    for (const DataFault& fault : log.faults) faults.push_back(message(fault));
    sources.push_back(
        {{"file", log.file}, {"sha256", log.sha256}, {"rows", log.rows}, {"faults", faults}});
  }
  const Json whole{
      {"model", o.model},          {"experiment", o.experiment}, {"identified", report.identified},
      {"results", report.results}, {"missing", report.missing},  {"logs", sources}};
  write_whole(o.out, whole.dump(2) + "\n");
  if (o.json) {
    fmt::print("{}\n", whole.dump(2));
  } else {
    for (const auto& [name, value] : report.results.items())
      if (value.is_object())
        fmt::print("{}: {:.6g} +- {:.2g}\n", name, value["value"].get<double>(),
                   value["standard_error"].get<double>());
      else if (!value.is_array() || value.size() <= 10)
        fmt::print("{}: {}\n", name, value.dump());
    for (const std::string& text : report.missing) fmt::print("not identified: {}\n", text);
    fmt::print("written to {}\n", o.out);
  }
  return report.identified ? 0 : 1;
}

}  // namespace

void add_identify_command(CLI::App& app, int& exit_status) {
  CLI::App* command =
      app.add_subcommand("identify", "Friction, inertia, ripple or the lever's sensor from logs");
  auto options = std::make_shared<Options>();
  command->add_option("model", options->model, "Model folder of the motor or lever")->required();
  command->add_option("--experiment", options->experiment, "friction, inertia, ripple or lever")
      ->required()
      ->check(CLI::IsMember({"friction", "inertia", "ripple", "lever"}));
  command->add_option("--log", options->logs, "CSV logs (docs/logs.md)")->required();
  command->add_option("--map", options->map, "channel=column [unit]");
  command->add_option("--out", options->out, "JSON file of the results")->required();
  command->add_option("--emit", options->emit, "lever: folder for the C of the calibration");
  command->add_flag("--json", options->json, "Report for machines");
  command->callback([options, &exit_status] { exit_status = run_identify(*options); });
}

}  // namespace sinew
