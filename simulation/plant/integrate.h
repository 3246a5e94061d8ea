// SPDX-License-Identifier: GPL-3.0-or-later
// From a state to the next output: by SUNDIALS CVODE, or by fixed steps as firmware takes them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simulation/plant/plant.h"

namespace sinew {

/// Something that happened between two outputs.
struct Event {
  double time = 0.0;  ///< s
  std::string name;   ///< slack_3, tendon_sticks_1, motor_sticks_2
  bool begins = true;
};

/// Called at every output time in order.
using OnOutput = std::function<void(double time, const double* y)>;
/// Called at the start and after every step. `work`: integral of each power since the start [J].
using OnStep = std::function<void(double time, const double* y, const Powers& work)>;
using OnEvent = std::function<void(const Event&)>;

struct IntegrationCount {
  long steps = 0;
  long evaluations = 0;  ///< of the right-hand side
  long jacobians = 0;
};

struct IntegrationCalls {
  OnOutput output;
  OnStep step;
  OnEvent event;
};

/// Integrates over the scenario's duration. Throws std::runtime_error with the time where the
/// integration fails or the state is no longer finite.
IntegrationCount integrate(Plant& plant, const IntegrationCalls& calls);

/// Fixed steps of the scenario's length from a state at a time on, without events and books;
/// `output` after each of them. Throws std::runtime_error as integrate does.
void integrate_stretch(Plant& plant, double start, const Eigen::VectorXd& state, long steps,
                       const OnOutput& output);

/// The two families behind it.
IntegrationCount integrate_by_cvode(Plant& plant, const IntegrationCalls& calls);
IntegrationCount integrate_by_fixed_steps(Plant& plant, const IntegrationCalls& calls);

/// Time of output `k`: the last one is the duration.
double output_time(const Scenario& scenario, long k);
/// Number of outputs, the first one at 0 included.
long output_count(const Scenario& scenario);

}  // namespace sinew
