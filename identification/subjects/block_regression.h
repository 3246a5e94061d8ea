// SPDX-License-Identifier: GPL-3.0-or-later
// What a joint's measured effort consists of, by plain least squares over blocks of time: enough to
// see units and torque constants before any cause is looked for.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/candidate.h"
#include "identification/subjects/effort_model.h"

namespace sinew::diagnosis {

/// A log's motion and efforts below 10 Hz, away from its ends: samples x joints.
struct SmoothEfforts {
  Eigen::MatrixXd qd, qdd, measured;
  Eigen::MatrixXd said;      ///< by the model
  Eigen::MatrixXd at_rest;   ///< by the model in the same poses, standing still
  Eigen::MatrixXd starting;  ///< by the model at no speed, with the accelerations
};

SmoothEfforts smooth_efforts(const Recording& log, const EffortModel& model);

/// An estimate and its standard error.
struct Share {
  double value = 0.0, standard_error = 0.0;
};

/// Least squares over blocks of time. Neighbours in time are no new samples: the standard errors
/// are those of leaving out one of ten blocks of each stretch.
class BlockRegression {
 public:
  /// asked: how many of the columns, the first ones, are asked for.
  explicit BlockRegression(Eigen::Index asked) : asked_(asked) {}

  /// One stretch: samples x columns, as many columns every time. Where `counts` is 0 a sample is
  /// left out.
  void add(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target,
           const Eigen::VectorXd& counts);
  /// A joint's measured effort on `columns`, all of them asked for, beside own_drive().
  void add_joint(const SmoothEfforts& log, Eigen::Index joint, const Eigen::MatrixXd& columns);
  /// Of the columns asked for.
  std::vector<Share> shares() const;

 private:
  template <typename Function>
  Share estimated(const Function& of_coefficients) const;
  Eigen::VectorXd solved(int without) const;

  Eigen::Index asked_;
  std::vector<Eigen::MatrixXd> gram_;
  std::vector<Eigen::VectorXd> target_;
};

/// An armature, viscous and Coulomb friction and an offset of a joint's own: samples x 4.
Eigen::MatrixXd own_drive(const Eigen::VectorXd& speed, const Eigen::VectorXd& acceleration);

/// 1 where a joint moves, 0 at standstill, where its friction may be anything.
Eigen::VectorXd in_motion(const Eigen::VectorXd& speed);

}  // namespace sinew::diagnosis
