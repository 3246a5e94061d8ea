// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "simulation/scenario/command_table.h"
#include "simulation/scenario/scenario.h"
#include "symbolic/files/identifier.h"
#include "symbolic/files/limits.h"
#include "symbolic/files/read_text.h"
#include "symbolic/files/readable.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> drive_words{"torque", "servo", "prescribed", "tendon_forces",
                                           "joint_torques"};
const std::vector<std::string> integrator_words{"cvode_bdf", "cvode_adams", "fixed_step",
                                                "runge_kutta_4"};
const std::vector<std::string> wrist_words{"prescribed", "dynamic"};
const std::vector<std::string> guiding_words{"none", "fitted", "capstan"};
const std::vector<std::string> wave_words{"constant", "ramp", "sine"};

template <typename Choice>
void take_word(TomlTable& table, std::string_view key, const std::vector<std::string>& words,
               Choice& choice) {
  const auto given = table.word(key, words, words[static_cast<std::size_t>(choice)]);
  if (given)
    choice = static_cast<Choice>(std::find(words.begin(), words.end(), *given) - words.begin());
}

/// Names of a channel's key in messages: "expected one of" with a suggestion.
void report_unknown(TomlTable& table, std::string_view key, const std::string& name,
                    const std::string& what, const std::map<std::string, Dimension>& known) {
  std::vector<std::string> names;
  for (const auto& [each, ignored] : known) names.push_back(each);
  table.report(key,
               fmt::format("the model has no {} '{}'{}", what, name, did_you_mean(name, names)),
               fmt::format("expected one of: {}", listed(names)));
}

/// The quantities of a scenario are what its author wants, and need not say where they come from.
void mark_as_chosen(toml::table& table) {
  const toml::node* value = table.get("value");
  if (value && (value->is_number() || value->is_array()) && !table.contains("from"))
    table.insert("from", "assumed");
  for (auto&& [key, node] : table) {
    if (toml::table* inner = node.as_table()) mark_as_chosen(*inner);
    if (toml::array* array = node.as_array())
      for (toml::node& entry : *array)
        if (toml::table* inner = entry.as_table()) mark_as_chosen(*inner);
  }
}

class ScenarioReader {
 public:
  ScenarioReader(const fs::path& path, Findings& findings)
      : findings_(findings), file_{path.string(), findings, provenance_} {
    scenario_.file = path.string();
    const std::string text = read_text(path, findings);
    findings.raise_if_any();
    root_ = parse_toml(text, file_);
    findings.raise_if_any();
    mark_as_chosen(root_);
  }

  DriveMode drive_mode() {
    TomlTable root(root_, "", file_);
    if (auto drive = root.table("drive", false))
      take_word(*drive, "mode", drive_words, scenario_.drive);
    return scenario_.drive;
  }

  WristMode wrist_mode() {
    TomlTable root(root_, "", file_);
    if (auto wrist = root.table("wrist", false))
      take_word(*wrist, "mode", wrist_words, scenario_.wrist);
    return scenario_.wrist;
  }

  Scenario read(const ScenarioChannels& channels) {
    channels_ = &channels;
    TomlTable root(root_, "", file_);
    if (auto table = root.table("scenario", true)) read_times(*table);
    if (auto table = root.table("integrator", false)) read_integrator(*table);
    if (auto table = root.table("drive", false)) read_drive(*table);
    if (auto table = root.table("losses", false)) read_losses(*table);
    if (auto table = root.table("wrist", false)) read_wrist(*table);
    if (auto table = root.table("initial", false)) read_initial(*table);
    if (auto table = root.table("noise", false)) read_noise(*table);
    if (auto table = root.table("commands", false)) read_commands(*table);
    for (TomlTable& table : root.tables("command")) read_command(table);
    root.finish();
    findings_.raise_if_any();
    return std::move(scenario_);
  }

 private:
  enum class Sign { any, not_negative, positive };

  void take(TomlTable& table, std::string_view key, Dimension dimension, double& value,
            Sign sign = Sign::any, bool required = false) {
    const auto quantity = table.quantity(key, Shape::scalar, dimension, required);
    if (!quantity) return;
    const double given = quantity->values.front();
    if (given < 0.0 && sign != Sign::any)
      table.report(key, fmt::format("{}.{} is negative", table.path(), key),
                   sign == Sign::positive ? "expected a value > 0" : "expected a value >= 0");
    else if (given == 0.0 && sign == Sign::positive)
      table.report(key, fmt::format("{}.{} is 0", table.path(), key), "expected a value > 0");
    else
      value = given;
  }

  void read_times(TomlTable& table) {
    take(table, "duration", Dimension::time, scenario_.duration, Sign::positive, true);
    take(table, "output_rate", Dimension::frequency, scenario_.output_rate, Sign::positive, true);
    if (const auto g = table.quantity("gravity", Shape::vector, Dimension::acceleration, false))
      scenario_.gravity = Eigen::Vector3d(g->values[0], g->values[1], g->values[2]);
    if (scenario_.duration > limits::run_seconds)
      table.report("duration", fmt::format("the run lasts {} s", scenario_.duration),
                   fmt::format("expected at most {} s", limits::run_seconds));
    if (scenario_.duration * scenario_.output_rate > limits::run_rows)
      table.report("duration", fmt::format("the output has more than {:g} rows", limits::run_rows),
                   "expected fewer");
    table.finish();
  }

  void read_integrator(TomlTable& table) {
    take_word(table, "method", integrator_words, scenario_.integrator);
    take(table, "relative_tolerance", Dimension::none, scenario_.relative_tolerance,
         Sign::positive);
    take(table, "absolute_tolerance", Dimension::none, scenario_.absolute_tolerance,
         Sign::positive);
    take(table, "step", Dimension::time, scenario_.step, Sign::positive);
    if (scenario_.duration > limits::run_steps * scenario_.step)
      table.report("step", fmt::format("the run has more than {:g} steps", limits::run_steps),
                   "expected a longer step or a shorter duration");
    table.finish();
  }

  void read_drive(TomlTable& table) {
    take_word(table, "mode", drive_words, scenario_.drive);
    take(table, "gain", Dimension::torque, scenario_.gain, Sign::not_negative);
    take(table, "rate_gain", Dimension::angular_damping, scenario_.rate_gain, Sign::not_negative);
    take(table, "pretension", Dimension::force, scenario_.pretension, Sign::not_negative);
    scenario_.compensation = table.truth("compensation").value_or(false);
    scenario_.wrist_feedforward = table.truth("wrist_feedforward").value_or(false);
    scenario_.weight_feedforward = table.truth("weight_feedforward").value_or(false);
    if (scenario_.weight_feedforward && scenario_.drive != DriveMode::servo &&
        scenario_.drive != DriveMode::prescribed)
      table.report("weight_feedforward", "weight_feedforward needs motors that follow positions",
                   "expected the mode servo or prescribed");
    if (scenario_.weight_feedforward && !(scenario_.pretension > 0.0))
      table.report("weight_feedforward", "tendons without pretension cannot pull both ways",
                   "expected pretension = { value = ..., unit = \"N\" }");
    if (scenario_.drive == DriveMode::servo && !(scenario_.gain > 0.0))
      table.report("gain", "a servo has no gain",
                   "expected gain = { value = ..., unit = \"N*m\" }");
    table.finish();
  }

  void read_losses(TomlTable& table) {
    scenario_.motor_friction = table.truth("motor_friction").value_or(true);
    scenario_.motor_ripple = table.truth("motor_ripple").value_or(true);
    scenario_.joint_damping = table.truth("joint_damping").value_or(true);
    scenario_.joint_friction = table.truth("joint_friction").value_or(true);
    take_word(table, "guiding", guiding_words, scenario_.guiding);
    take(table, "fixed_bending", Dimension::angle, scenario_.fixed_bending, Sign::not_negative);
    take(table, "crank_inertia", Dimension::inertia, scenario_.crank_inertia, Sign::positive);
    table.finish();
  }

  void read_wrist(TomlTable& table) {
    take_word(table, "mode", wrist_words, scenario_.wrist);
    take(table, "inertia", Dimension::inertia, scenario_.wrist_inertia, Sign::positive);
    take(table, "damping", Dimension::angular_damping, scenario_.wrist_damping, Sign::not_negative);
    table.finish();
  }

  void read_initial(TomlTable& table) {
    for (const auto& [name, dimension] : channels_->initial)
      if (const auto quantity = table.quantity(name, Shape::scalar, dimension, false))
        scenario_.initial[channels_->own_name(name)] = quantity->values.front();
    table.finish();
  }

  void read_noise(TomlTable& table) {
    double seed = 1.0;
    take(table, "seed", Dimension::none, seed, Sign::not_negative);
    scenario_.noise.seed = static_cast<unsigned long>(std::min(seed, 9e15));
    take(table, "q", Dimension::angle, scenario_.noise.position, Sign::not_negative);
    take(table, "theta", Dimension::angle, scenario_.noise.theta, Sign::not_negative);
    take(table, "omega", Dimension::angular_velocity, scenario_.noise.omega, Sign::not_negative);
    take(table, "tau", Dimension::torque, scenario_.noise.torque, Sign::not_negative);
    take(table, "force", Dimension::force, scenario_.noise.force, Sign::not_negative);
    table.finish();
  }

  void read_commands(TomlTable& table) {
    if (const auto name = table.text("file", true)) {
      const fs::path path = fs::path(scenario_.file).parent_path() / *name;
      scenario_.tables.push_back(path.string());
      for (const auto& [channel, samples] :
           read_command_table(path, channels_->commands, findings_)) {
        scenario_.commands[channels_->own_name(channel)].add(samples);
        for (std::size_t i = 1; i < samples.time.size(); ++i) {
          const double period = samples.time[i] - samples.time[i - 1];
          if (scenario_.longest_step == 0.0 || period < scenario_.longest_step)
            scenario_.longest_step = period;
        }
      }
    }
    table.finish();
  }

  void read_command(TomlTable& table) {
    const auto channel = table.text("channel", true);
    Wave wave;
    take_word(table, "shape", wave_words, wave.shape);
    take(table, "from", Dimension::time, wave.from);
    take(table, "to", Dimension::time, wave.to);
    if (!channel) return;
    const auto known = channels_->commands.find(*channel);
    if (known == channels_->commands.end()) {
      report_unknown(table, "channel", *channel, "command", channels_->commands);
      return;
    }
    take(table, "value", known->second, wave.value, Sign::any, wave.shape == WaveShape::constant);
    if (wave.shape == WaveShape::ramp) take_rate(table, known->second, wave);
    if (wave.shape == WaveShape::sine) {
      take(table, "amplitude", known->second, wave.amplitude, Sign::any, true);
      take(table, "frequency", Dimension::frequency, wave.frequency, Sign::positive, true);
      if (wave.frequency * scenario_.duration > limits::sine_periods)
        table.report(
            "frequency",
            fmt::format("the sine has more than {:g} periods in the run", limits::sine_periods),
            "expected a lower frequency or a shorter duration");
      take(table, "phase", Dimension::angle, wave.phase);
    }
    if (wave.to <= wave.from)
      table.report("to", "the command ends before it begins", "expected to > from");
    table.finish();
    scenario_.commands[channels_->own_name(*channel)].add(wave);
  }

  /// A ramp's rise over its time; the rate of a torque or force has no unit of its own.
  void take_rate(TomlTable& table, Dimension dimension, Wave& wave) {
    double rise = 0.0;
    take(table, "rise", dimension, rise, Sign::any, true);
    if (!table.has("to"))
      table.report("to", "a ramp has no end", "expected to = { value = ..., unit = \"s\" }");
    else if (wave.to > wave.from)
      wave.rate = rise / (wave.to - wave.from);
  }

  Findings& findings_;
  std::map<std::string, std::string> provenance_;
  TomlFile file_;
  toml::table root_;
  Scenario scenario_;
  const ScenarioChannels* channels_ = nullptr;
};

}  // namespace

DriveMode read_drive_mode(const fs::path& file) {
  Findings findings;
  const DriveMode mode = ScenarioReader(file, findings).drive_mode();
  findings.raise_if_any();
  return mode;
}

WristMode read_wrist_mode(const fs::path& file) {
  Findings findings;
  const WristMode mode = ScenarioReader(file, findings).wrist_mode();
  findings.raise_if_any();
  return mode;
}

Scenario read_scenario(const fs::path& file, const ScenarioChannels& channels) {
  Findings findings;
  return ScenarioReader(file, findings).read(channels);
}

}  // namespace sinew
