// SPDX-License-Identifier: GPL-3.0-or-later
// All axes of a chain in closed loop: friction and what is hidden at the axes are applied, the
// controller knows the model under test only.
#pragma once

#include "tests/blind/truth/jointed.h"

namespace sinew::trials {

/// Moves the axes on by one step.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual void start(const VectorXd& q, const VectorXd& v) = 0;
  virtual VectorXd q() const = 0;
  virtual VectorXd v() const = 0;
  /// Speeds at the end of a step under these efforts.
  virtual VectorXd speed_after(const VectorXd& effort) = 0;
  /// By how much an effort at one axis moves the speeds of all within a step: axes x axes.
  virtual MatrixXd mobility() = 0;
  virtual void advance(const VectorXd& effort) = 0;
};

/// The chain's bodies as they really are, inertias that are hidden at the axes among them.
Chain chain_in_motion(const Jointed& jointed, const std::vector<Hidden>& hidden);

/// `bandwidth` of the position loop [rad/s].
Course in_torque_control(const Jointed& jointed, const std::vector<Hidden>& hidden,
                         const Course& wanted, const VectorXd& load, double bandwidth,
                         Integrator& integrator);

}  // namespace sinew::trials
