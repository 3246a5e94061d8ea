// SPDX-License-Identifier: GPL-3.0-or-later
// Tendons that drive joints: their signals from measured forces, and what they may get wrong.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identification/regression/candidate.h"
#include "simulation/emitted/compiled_model.h"
#include "symbolic/effects/effect.h"
#include "symbolic/extension/driven_model.h"

namespace sinew::diagnosis {

class TendonColumns {
 public:
  /// `runtime`: folder of the runtime's headers. For a model whose joints tendons drive.
  TendonColumns(const DrivenModel& model, const std::filesystem::path& runtime);

  /// From signal "tension" (samples x tendons, N) and the motion: "moment_arm" (samples x tendons *
  /// coordinates), "slow_tension", "tendon_rate", "bending", "tendon_direction" (samples x
  /// tendons), where there are motors also "motor_side_rate" and "motor_side_direction".
  void add_signals(Recording& log) const;

  /// samples x coordinates: -P^T f, the joint torques of the measured forces (5.11).
  Eigen::MatrixXd joint_torque(const Recording& log) const;

  /// Effects of the catalogue that have their place at a tendon, each at each tendon.
  struct AtTendon {
    Candidate candidate;
    std::string effect, place;
  };
  std::vector<AtTendon> candidates() const;

  Eigen::Index coordinates() const { return coordinates_; }

 private:
  Candidate candidate(const Effect& effect, Eigen::Index tendon) const;

  std::vector<std::string> names_;
  double slip_speed_;
  Eigen::Index coordinates_;
  std::optional<double> motor_radius_;  ///< m, where the motors' motion is logged
  std::shared_ptr<CompiledModel> compiled_;
};

/// All moment arms at a joint are larger or smaller by one share: its pulleys' radius. Uses signal
/// "effort".
Candidate pulley_radius_candidate(int axis, const std::string& place);

}  // namespace sinew::diagnosis
