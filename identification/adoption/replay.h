// SPDX-License-Identifier: GPL-3.0-or-later
// A log played again: its efforts command the simulation, its motion is what that should have been.
#pragma once

#include <string>
#include <vector>

#include "identification/subjects/driven_channels.h"
#include "simulation/plant/plant.h"

namespace sinew::diagnosis {

/// The longest stretch of a log without gaps.
struct Replay {
  Recording log;      ///< q, qd, qdd, load, "tension"
  Scenario scenario;  ///< in fixed steps of the log's, from its first state on
};

/// `model`: whose joints the channels are. Joints by their efforts, or by the forces of their
/// tendons; a motor alone by its torque. Throws std::runtime_error where no stretch is longer than
/// a prediction's window.
Replay replay_of(const Log& log, const DrivenChannels& channels, const DrivenModel& model);

/// How far the simulated position of a coordinate is from the logged one, root mean square.
struct ReplayError {
  std::string channel, unit;
  double open_loop = 0.0;  ///< over the whole stretch; infinite where a run left all bounds
  double window = 0.0;     ///< over prediction_window from the measured state, all over the stretch
};

/// `rows`: what simulate() gave for the scenario; time first, then the positions. The plant is the
/// scenario's.
std::vector<ReplayError> replay_errors(const Replay& replay, const DrivenChannels& channels,
                                       const std::vector<std::vector<double>>& rows, Plant& plant);

}  // namespace sinew::diagnosis
