// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/channels.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/models/model_folder.h"
#include "cli/terminal/report_stream.h"
#include "cli/terminal/terminal.h"
#include "identification/logs/csv_rows.h"
#include "identification/logs/guess_channels.h"

namespace sinew {
namespace {

struct ChannelsOptions {
  std::string model, log, out;
};

struct ModelChannels {
  std::vector<ChannelSpec> specs;
  std::vector<std::string> joints;
};

std::vector<ChannelSpec> part_channels(const ModelFolder& folder) {
  const auto& parameters = std::get<Part>(folder.model).parameters;
  if (std::holds_alternative<MotorParameters>(parameters)) return rotary_drive_channels();
  if (const auto* wrist = std::get_if<WristParameters>(&parameters))
    return wrist_channels(static_cast<int>(wrist->forearm_points.size()));
  if (std::holds_alternative<LeverParameters>(parameters) ||
      std::holds_alternative<TendonWithLever>(parameters))
    return lever_channels();
  throw std::runtime_error(folder.folder.string() +
                           ": no log is read of this part; expected a mechanism, a motor, a lever, "
                           "a tendon or a wrist");
}

/// Of a finger on tendons only what every log of it has: its joints.
ModelChannels channels_of(const ModelFolder& folder) {
  if (const Mechanism* mechanism = std::get_if<Mechanism>(&folder.model)) {
    ModelChannels result{robot_channels(*mechanism), {}};
    for (const NamedJoint& joint : folder.identity.naming.joints)
      result.joints.push_back(joint.name);
    if (mechanism->tendons.empty()) return result;
    std::vector<int> numbers;
    for (std::size_t i = 1; i <= mechanism->tendons.size(); ++i)
      numbers.push_back(static_cast<int>(i));
    result.specs = finger_channels(*mechanism, numbers, true, true);
    return result;
  }
  if (std::holds_alternative<Hand>(folder.model))
    throw std::runtime_error(folder.folder.string() +
                             ": columns of a hand's log are not guessed; name them in its "
                             "channels.toml (docs/logs.md)");
  return {part_channels(folder), {}};
}

bool is_found(const ChannelGuess& guess) {
  return guess.kind == GuessKind::understood || guess.kind == GuessKind::guessed;
}

/// A finger's log has forces of its tendons, or angles and torques of their motors.
void need_one_of_both(std::vector<ChannelGuess>& guesses) {
  const auto is_force = [](const ChannelGuess& g) { return g.channel.starts_with("force_"); };
  const auto is_motor = [](const ChannelGuess& g) {
    return g.channel.starts_with("theta_") || g.channel.starts_with("tau_");
  };
  const bool forces = std::any_of(guesses.begin(), guesses.end(), [&](const ChannelGuess& g) {
    return is_force(g) && is_found(g);
  });
  for (ChannelGuess& guess : guesses)
    if (forces ? is_motor(guess) : is_force(guess)) guess.required = false;
}

int run_channels(const ChannelsOptions& o) {
  Inputs inputs;
  recover_model(o.model);
  add_model(inputs, o.model);
  inputs.add(o.log);
  check_output_file(o.out, inputs);
  const ModelChannels channels = channels_of(open_model_folder(o.model));
  const CsvReader log(o.log);
  auto guesses = guess_channels(log.dialect().header, channels.specs, channels.joints);
  if (std::any_of(channels.specs.begin(), channels.specs.end(),
                  [](const ChannelSpec& s) { return s.name == "force_1"; }))
    need_one_of_both(guesses);
  Outputs outputs;
  outputs.protect(inputs);
  outputs.file(o.out, guessed_channels_toml(guesses, o.log));
  outputs.commit();
  const auto count = [&](GuessKind kind) {
    return std::count_if(guesses.begin(), guesses.end(),
                         [&](const ChannelGuess& g) { return g.kind == kind; });
  };
  const auto open = std::count_if(guesses.begin(), guesses.end(),
                                  [](const ChannelGuess& g) { return g.required && !is_found(g); });
  print_to(stream_of_report(o.out),
           "{}: {} channels understood as they are, {} guessed, {} that are needed are open\n"
           "  confirm them, then put the file into the model's folder as channels.toml\n",
           o.out, count(GuessKind::understood), count(GuessKind::guessed), open);
  return open ? 1 : 0;
}

}  // namespace

void add_channels_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "channels", "Guess from a log's header which column is which channel, for confirmation");
  auto options = std::make_shared<ChannelsOptions>();
  command->add_option("model", options->model, "Model folder")->required();
  command->add_option("--log", options->log, "A log, as text or in MAT or HDF5 format")->required();
  command->add_option("--out", options->out, "The file to confirm; - is standard output")
      ->required();
  command->callback([options, &exit_status] { exit_status = run_channels(*options); });
}

}  // namespace sinew
