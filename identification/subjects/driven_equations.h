// SPDX-License-Identifier: GPL-3.0-or-later
// What each measured effort of a driven mechanism may consist of, as its model and the machine's
// likely defects say.
#pragma once

#include <memory>
#include <vector>

#include "identification/subjects/effort_model.h"
#include "identification/subjects/reading_equations.h"
#include "identification/subjects/rigid_candidates.h"
#include "symbolic/extension/driven_model.h"

namespace sinew::diagnosis {

/// A machine's own torque constants and force sensors: standard deviation of the logarithm of what
/// they are off by.
inline constexpr double kOwnConstant = 0.12;

/// Of one measured effort, samples in which its coordinate moves.
struct EffortParts {
  Eigen::VectorXd measured, said;
  double moving = 0.0;      ///< share of the log's samples that these are
  Eigen::MatrixXd links;    ///< of each body, see RigidColumns::body_columns()
  Eigen::VectorXd load;     ///< what the logged load makes of `said`; empty: none is logged
  Eigen::MatrixXd drive;    ///< the rest of `said`: at rest, by acceleration, viscous, Coulomb
  Eigen::VectorXd slow;     ///< what friction is beside the last two, at low speeds
  Eigen::MatrixXd curve;    ///< over the coordinate's reach, of what goes with the position alone
  Eigen::MatrixXd own;      ///< unit inertia, viscous and Coulomb friction of the coordinate
  Eigen::MatrixXd tendons;  ///< torque of each tendon's measured force; no columns: none
  Eigen::MatrixXd guides;   ///< the same against the tendon's motion: friction in its guides
};

class DrivenEquations {
 public:
  /// rigid: null where the links are not known one by one; all have to outlive the object.
  DrivenEquations(const DrivenModel& model, const EffortModel& effort, const RigidColumns* rigid,
                  Eigen::Index efforts);

  /// Measured efforts are those of the last coordinates.
  Eigen::Index measured() const { return measured_; }
  /// Of these, joints that tendons drive come first.
  Eigen::Index by_tendons() const { return by_tendons_; }

  /// A target for each measured effort; see SlowColumns::read_as().
  std::vector<EffortParts> parts_of(const Recording& recording) const;

  /// What the model says at a log's motion.
  struct Logged;
  std::shared_ptr<const Logged> logged(const Recording& recording) const;
  /// The same parts where the recording has that motion, at its pace or at another.
  std::vector<EffortParts> parts_of(const Recording& recording, const Logged& motion) const;

  /// Of each measured effort: its log likelihood alone, all unknowns being what suits it best.
  std::vector<double> evidence_each(const std::vector<EffortParts>& parts) const;
  /// Of all, with what they have in common.
  double evidence(const std::vector<EffortParts>& parts) const;
  /// Share of each one's variance that is left over where the machine is as it is drawn, but for an
  /// inertia and friction where the model is without: of these any.
  std::vector<double> left_as_drawn(const std::vector<EffortParts>& parts) const;

 private:
  struct Said;
  Said said_of(const Recording& recording, Eigen::MatrixXd links) const;
  std::vector<EffortParts> parts_of(const Recording& recording, const Said& said) const;
  EffortParts parts_at(const Recording& recording, const Said& said, Eigen::Index i) const;
  Eigen::MatrixXd links_at(const Recording& recording) const;
  Eigen::Index coordinate(Eigen::Index i) const { return coordinates_ - measured_ + i; }
  double usual(const std::vector<EffortParts>& parts, std::size_t i) const;
  int kind_of(Eigen::Index i) const;
  double expected_drive(Eigen::Index i, double usual) const;
  EffortEquation equation_of(const EffortParts& parts, double usual, double drive,
                             std::vector<Unknown>& unknowns) const;
  double evidence_alone(const std::vector<EffortParts>& parts, std::size_t i) const;

  const DrivenModel& model_;
  const EffortModel& effort_;
  const RigidColumns* rigid_;
  Eigen::Index coordinates_, measured_, by_tendons_;
};

}  // namespace sinew::diagnosis
