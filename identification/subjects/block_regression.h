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
  Eigen::MatrixXd said;     ///< by the model
  Eigen::MatrixXd at_rest;  ///< by the model in the same poses, standing still
};

SmoothEfforts smooth_efforts(const Recording& log, const EffortModel& model);

/// An estimate and its standard error.
struct Share {
  double value = 0.0, standard_error = 0.0;
};

/// Least squares of one joint's effort on some columns beside an armature, viscous and Coulomb
/// friction and an offset of its own, standstill aside. Neighbours in time are no new samples: the
/// standard errors are those of leaving out one of ten blocks of each log.
class BlockRegression {
 public:
  explicit BlockRegression(Eigen::Index columns) : own_(columns) {}

  /// columns: samples x the columns asked for.
  void add(const SmoothEfforts& log, Eigen::Index joint, const Eigen::MatrixXd& columns);
  /// Of the columns asked for.
  std::vector<Share> shares() const;

 private:
  Eigen::VectorXd solved(int without) const;

  Eigen::Index own_;
  std::vector<Eigen::MatrixXd> gram_;
  std::vector<Eigen::VectorXd> target_;
};

}  // namespace sinew::diagnosis
