// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "firmware/exchange.h"
#include "simulation/loop/hand_sensors.h"

namespace sinew {

struct HandController::Step {
  hand_state state{};
  hand_input input{};
  hand_output output{};
};

HandController::HandController(Plant& plant, const hand_parameters& parameters)
    : plant_(plant),
      sensors_(plant, parameters),
      parameters_(parameters),
      step_(std::make_unique<Step>()) {
  if (hand_start(&step_->state, &parameters) != HAND_START_FINE)
    throw std::invalid_argument(
        "the table of the real-time step is damaged; make it again with sinew parameters");
}

HandController::~HandController() = default;

void HandController::tick(const std::vector<double>& row) {
  // Through the mailbox's words: numbers are rounded as they are on the way to a board.
  const mailbox_measured measured = sensors_.measured(row, ++frame_);
  const mailbox_setpoint setpoint = sensors_.setpoint(row.front());
  exchange_measured(&measured, &step_->input);
  exchange_setpoint(&setpoint, MAILBOX_DRIVE, &step_->input);
  hand_step(&step_->state, &parameters_, &step_->input, &step_->output);
  mailbox_answer answer{};
  exchange_answer(&step_->output, &answer);
  Eigen::VectorXd torque(HAND_TENDONS);
  for (int i = 0; i < HAND_TENDONS; ++i) torque(i) = 1e-6 * answer.torque[i];
  plant_.hold_torque(torque);
  // The first ticks are those in which the sensors come up.
  if (frame_ > 2 * parameters_.wrist_limits.settle_ticks) status_ |= step_->output.status;
}

const hand_output& HandController::output() const {
  return step_->output;
}

}  // namespace sinew
