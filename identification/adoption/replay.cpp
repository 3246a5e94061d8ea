// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "identification/adoption/prediction.h"
#include "identification/logs/filter.h"
#include "identification/regression/position_noise.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd channels_of(const Log& log, const sinew::Segment& segment,
                     const std::vector<std::string>& names) {
  MatrixXd values(segment.samples.rows(), static_cast<Index>(names.size()));
  for (std::size_t c = 0; c < names.size(); ++c)
    values.col(static_cast<Index>(c)) = segment.samples.col(log.channel(names[c])).matrix();
  return values;
}

const sinew::Segment& longest_stretch(const Log& log) {
  const auto longest = std::max_element(
      log.segments.begin(), log.segments.end(),
      [](const auto& a, const auto& b) { return a.samples.rows() < b.samples.rows(); });
  if (longest == log.segments.end() ||
      static_cast<double>(longest->samples.rows()) * log.period <= prediction_window)
    throw std::runtime_error(fmt::format("{}: no stretch without gaps is longer than {} s",
                                         log.file, prediction_window));
  return *longest;
}

Recording recording_of(const Log& log, const sinew::Segment& stretch,
                       const std::vector<std::string>& positions, const DrivenChannels& channels) {
  Recording r;
  r.name = log.file;
  r.step = log.period;
  const Index n = stretch.samples.rows();
  r.time = VectorXd::LinSpaced(n, 0.0, log.period * static_cast<double>(n - 1));
  Motion motion =
      differentiate(channels_of(log, stretch, positions), log.period, motion_cutoff(log.period));
  r.q = std::move(motion.q);
  r.qd = std::move(motion.qd);
  r.qdd = std::move(motion.qdd);
  if (!channels.load.empty() && log.channel(channels.load) >= 0)
    r.load = channels_of(log, stretch, {channels.load});
  if (!channels.forces.empty()) r.signals["tension"] = channels_of(log, stretch, channels.forces);
  return r;
}

/// Commands are the log's columns; the names are the plant's.
void add_commands(const Recording& log, const MatrixXd& efforts, const DrivenChannels& channels,
                  const DrivenModel& model, Scenario& scenario) {
  const std::vector<double> time(log.time.begin(), log.time.end());
  const auto add = [&](const std::string& channel, const VectorXd& values) {
    scenario.commands[channel].add(SampledSignal{time, {values.begin(), values.end()}});
  };
  if (!channels.forces.empty()) {
    scenario.drive = DriveMode::tendon_forces;
    for (std::size_t i = 0; i < channels.forces.size(); ++i)
      add(channels.forces[i], log.signals.at("tension").col(static_cast<Index>(i)));
    return;
  }
  const bool alone = model.joints.front().motor;
  scenario.drive = alone ? DriveMode::torque : DriveMode::joint_torques;
  for (Index j = 0; j < efforts.cols(); ++j)
    add(alone ? "tau_m" : "tau_" + model.joints[static_cast<std::size_t>(j)].name, efforts.col(j));
  for (Index j = 0; j < log.load.cols(); ++j)
    add(alone ? "load" : "load_" + model.joints[static_cast<std::size_t>(j)].name, log.load.col(j));
}

void add_start(const Recording& log, const std::vector<std::string>& positions,
               const DrivenModel& model, Scenario& scenario) {
  for (Index j = 0; j < log.q.cols(); ++j) {
    const DrivenJoint& joint = model.joints[static_cast<std::size_t>(j)];
    // A hand's coordinates are called as they are logged.
    for (const std::string& name : {joint.name, positions[static_cast<std::size_t>(j)]}) {
      scenario.initial[name] = log.q(0, j);
      scenario.initial["qd_" + name] = log.qd(0, j);
    }
    if (!joint.motor) continue;
    scenario.initial["theta"] = log.q(0, j);
    scenario.initial["omega"] = log.qd(0, j);
  }
}

/// The motors of tendons are not simulated where the tendons' forces are given.
std::vector<std::string> simulated_positions(const DrivenChannels& channels,
                                             const DrivenModel& model) {
  std::vector<std::string> names = channels.positions;
  if (!channels.forces.empty())
    names.resize(static_cast<std::size_t>(
        std::count_if(model.joints.begin(), model.joints.end(),
                      [](const DrivenJoint& joint) { return !joint.motor; })));
  return names;
}

}  // namespace

Replay replay_of(const Log& log, const DrivenChannels& channels, const DrivenModel& model) {
  const sinew::Segment& stretch = longest_stretch(log);
  const std::vector<std::string> positions = simulated_positions(channels, model);
  Replay replay{recording_of(log, stretch, positions, channels), {}};
  Scenario& scenario = replay.scenario;
  scenario.file = log.file;
  scenario.duration = replay.log.time(replay.log.time.size() - 1);
  scenario.output_rate = 1.0 / log.period;
  scenario.integrator = Integrator::fixed_step;
  scenario.step = log.period;
  scenario.as_logged = true;
  add_commands(replay.log, channels_of(log, stretch, channels.efforts), channels, model, scenario);
  add_start(replay.log, positions, model, scenario);
  return replay;
}

std::vector<ReplayError> replay_errors(const Replay& replay, const DrivenChannels& channels,
                                       const std::vector<std::vector<double>>& rows, Plant& plant) {
  const Recording& log = replay.log;
  const int windows = channels.forces.empty() ? effort_windows : tendon_windows;
  const StretchErrors errors = window_errors(plant, log, prediction_window, windows);
  std::vector<ReplayError> result;
  for (Index j = 0; j < log.q.cols(); ++j) {
    const std::string& channel = channels.positions[static_cast<std::size_t>(j)];
    ReplayError error{channel, "", 0.0, 0.0};
    for (const ChannelSpec& spec : channels.specs)
      if (spec.name == channel) error.unit = spec.unit;
    const auto count = std::min<Index>(static_cast<Index>(rows.size()), log.q.rows());
    for (Index k = 1; k < count; ++k) {
      const double off =
          rows[static_cast<std::size_t>(k)][static_cast<std::size_t>(1 + j)] - log.q(k, j);
      error.open_loop += off * off;
    }
    error.open_loop =
        std::sqrt(error.open_loop / static_cast<double>(std::max<Index>(count - 1, 1)));
    error.window = std::sqrt(errors.col(j).mean());
    result.push_back(std::move(error));
  }
  return result;
}

}  // namespace sinew::diagnosis
