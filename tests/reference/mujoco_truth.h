// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo's dynamics of a mechanism: a truth from outside this project, where it is installed.
#pragma once

#include <memory>
#include <string>

#include "symbolic/model/mechanism.h"
#include "tests/reference/scalar.h"

namespace sinew::reference {

/// The mechanism as MJCF text: nested bodies, hinges and slides, no geometry.
std::string mujoco_text(const Mechanism& mechanism);

/// Whether this build found MuJoCo.
bool mujoco_available();

class MujocoTruth {
 public:
  /// Throws std::runtime_error with MuJoCo's message, or where this build has no MuJoCo.
  explicit MujocoTruth(const Mechanism& mechanism);
  ~MujocoTruth();

  Eigen::MatrixXd mass_matrix(const Eigen::VectorXd& q);
  Eigen::VectorXd bias(const Eigen::VectorXd& q, const Eigen::VectorXd& qd);
  Eigen::VectorXd inverse_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                                   const Eigen::VectorXd& qdd);

 private:
  struct Simulation;
  void set_state(const Eigen::VectorXd& q, const Eigen::VectorXd& qd);
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace sinew::reference
