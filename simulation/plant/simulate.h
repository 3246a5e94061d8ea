// SPDX-License-Identifier: GPL-3.0-or-later
// A scenario run on a model: log, events and audit.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "simulation/plant/integrate.h"

namespace sinew {

/// Energy books of a run, closed after every step.
struct Audit {
  double largest_energy = 0.0;   ///< J, largest |energy| and |work| seen: what residuals refer to
  double energy_residual = 0.0;  ///< J, largest |energy - start - sum of work|
  double power_residual = 0.0;   ///< largest |d(energy)/dt - sum of powers| over the powers' size
  double largest_friction_power = 0.0;  ///< W, of motor, guiding and damping: never above 0
  double energy_drift = 0.0;            ///< J, largest |energy - start|
  double lever_residual = 0.0;          ///< m, largest that the emitted lever searches leave over
  Powers work{};                        ///< J, at the end
};

struct SimulationResult {
  long rows = 0;
  double seconds = 0.0;  ///< of computing
  IntegrationCount count;
  Audit audit;
  std::map<std::string, long> event_counts;  ///< beginnings
  std::vector<Event> events;                 ///< the first 1000
};

/// One row of output [SI units], in the order of `columns`.
using OnRow = std::function<void(const std::vector<double>& row)>;

/// "time [s]", "q20 [rad]", "tau_1 [N·m]", …: channels as docs/logs.md names them.
std::vector<std::string> output_columns(const Plant& plant);

/// The books after a step: energy [J] and the integral of each power since the start [J].
using OnBooks = std::function<void(double time, double energy, const Powers& work)>;

/// Runs the plant's scenario. `progress` gets the time reached [s].
SimulationResult simulate(Plant& plant, const OnRow& row,
                          const std::function<void(double)>& progress = {},
                          const OnBooks& books = {});

/// Builds the plant of a model folder: a motor part, a mechanism or a hand. Motor, tendon and
/// guiding are read from the folders beside it (motor, tendon, guiding or capstan). `runtime`: the
/// runtime's headers. Throws DescriptionError, std::invalid_argument, std::runtime_error.
Plant build_plant(const std::filesystem::path& model, const std::filesystem::path& scenario,
                  const std::filesystem::path& runtime);

/// The same for a scenario put together by a program: its commands are not checked against the
/// model's channels.
Plant build_plant(const std::filesystem::path& model, const Scenario& scenario,
                  const std::filesystem::path& runtime);

}  // namespace sinew
