// SPDX-License-Identifier: GPL-3.0-or-later
// Tendons that drive joints: their signals from measured forces, and what they may get wrong.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identification/regression/candidate.h"
#include "identification/regression/standstill.h"
#include "simulation/emitted/compiled_model.h"
#include "symbolic/effects/effect.h"
#include "symbolic/extension/driven_model.h"

namespace sinew::diagnosis {

/// Standard deviation of a pulley's radius, of a guide's place as a share of the moment arm, and of
/// a force sensor's scale, before any log was seen: as of what else a drawing says.
inline constexpr double kDrawnArm = 0.2;

class TendonColumns {
 public:
  /// `runtime`: folder of the runtime's headers. For a model whose joints tendons drive.
  TendonColumns(const DrivenModel& model, const std::filesystem::path& runtime);

  /// From signal "tension" (samples x tendons, N) and the motion: "moment_arm" (samples x tendons *
  /// coordinates), "slow_tension", "tendon_rate", "bending", "tendon_direction" (samples x
  /// tendons), where there are motors also "motor_side_rate" and "motor_side_direction".
  void add_signals(Recording& log) const;

  /// From what the model says of the joints (`known`): signals "agreeing_tension" (samples x
  /// tendons, N), the slow part of the forces nearest to the measured ones that move the joints
  /// like that, and "tension_within_guide", halfway between these and the measured ones. Joints'
  /// efforts are made of the measured forces: a share of one of these would explain the efforts by
  /// themselves, friction and all.
  void add_agreeing_tension(Recording& log) const;

  /// Of each tendon, where it does not move in its guide. `cutoff` [Hz]: the smoother's.
  std::vector<Stillness> stillness(const Recording& log, double cutoff) const;

  /// samples x coordinates: -P^T f, the joint torques of the measured forces (5.11).
  Eigen::MatrixXd joint_torque(const Recording& log) const;

  /// Effects of the catalogue that have their place at a tendon, each at each tendon, and those of
  /// one make at all tendons with one coefficient.
  struct AtTendon {
    Candidate candidate;
    std::string effect, place;
    bool everywhere = false;
  };
  /// logs: as add_signals() left them; they say how large moment arms are.
  std::vector<AtTendon> candidates(const std::vector<Recording>& logs) const;

  /// Structure without a name: each tendon's force by any law, and by a share that changes over the
  /// log, as a force sensor that saturates or warms up. logs: as add_agreeing_tension() left them.
  std::vector<Candidate> structure(const std::vector<Recording>& logs) const;

  Eigen::Index coordinates() const { return coordinates_; }

 private:
  struct Joined {
    std::vector<Eigen::Index> joints, tendons;
  };
  Joined joined_to(const Function& motion, Eigen::Index tendon) const;
  Candidate candidate(const Effect& effect, Eigen::Index tendon) const;
  Candidate at_sensor(Candidate of_force, Eigen::Index tendon) const;
  Candidate common_candidate(const Effect& effect) const;
  Eigen::VectorXd lacking_tension(const Recording& log, Eigen::Index tendon, double larger) const;
  /// Of one tendon, whose moment arms are larger than the model's by that share.
  Eigen::VectorXd agreeing_tension(const Recording& log, Eigen::Index tendon, double larger) const;
  void expect_drawn(const std::vector<Recording>& logs, Eigen::Index tendon, Candidate& c) const;

  std::vector<std::string> names_;
  double slip_speed_;
  Eigen::Index coordinates_;
  std::vector<Joined> joined_;          ///< to each tendon, over joints and tendons between them
  std::optional<double> motor_radius_;  ///< m, where the motors' motion is logged
  std::shared_ptr<CompiledModel> compiled_;
};

/// All moment arms at a joint are larger or smaller by one share: its pulleys' radius. Uses signal
/// "effort".
Candidate pulley_radius_candidate(int axis, const std::string& place);

}  // namespace sinew::diagnosis
