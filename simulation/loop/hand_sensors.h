// SPDX-License-Identifier: GPL-3.0-or-later
// Between a simulated hand and the real-time step: what its sensors read, what it is told.
#pragma once

#include <memory>
#include <random>
#include <vector>

#include "firmware/hand/hand_step.h"
#include "firmware/mailbox.h"
#include "simulation/plant/simulate.h"

namespace sinew {

/// Of a motor's position word.
inline constexpr double counts_a_radian =
    static_cast<double>(MAILBOX_COUNTS_A_TURN) / 6.283185307179586;

/// Quantised as the sensors are, with noise in the lowest bits, which live ones show.
class HandSensors {
 public:
  /// `plant`: a hand in the drive mode torque whose palm follows commands; `parameters` of its
  /// real-time step. Throws std::invalid_argument for any other plant, and where a row is not one
  /// period.
  HandSensors(const Plant& plant, const hand_parameters& parameters);

  /// From a row of output (output_columns); `frame` is the caller's.
  mailbox_measured measured(const std::vector<double>& row, std::uint32_t frame);
  /// Commands `<joint>_ref` of the scenario at a time; joints without one stay where they start.
  mailbox_setpoint setpoint(double time) const;

 private:
  std::uint32_t word(double count, double highest);

  const Plant& plant_;
  const hand_parameters& parameters_;
  std::size_t theta_ = 0, lever_ = 0, wrist_ = 0;  ///< columns of the first of each
  std::vector<const Signal*> reference_;
  std::vector<double> start_;
  float gravity_[3];
  std::mt19937_64 random_{1};
};

/// hand_step as the controller of a simulated hand: to be called with every row, before the step
/// that follows it.
class HandController {
 public:
  HandController(Plant& plant, const hand_parameters& parameters);
  ~HandController();
  /// Measures, makes a tick, and puts its torques on the plant's motors.
  void tick(const std::vector<double>& row);
  std::uint32_t status() const { return status_; }  ///< bits of all ticks since the sensors settled
  const hand_output& output() const;                ///< of the last tick

 private:
  struct Step;
  Plant& plant_;
  HandSensors sensors_;
  const hand_parameters& parameters_;
  std::unique_ptr<Step> step_;
  std::uint32_t frame_ = 0, status_ = 0;
};

}  // namespace sinew
