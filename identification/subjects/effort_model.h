// SPDX-License-Identifier: GPL-3.0-or-later
// A driven model's emitted `effort`, compiled and run over recordings: what the model under test
// says a log's efforts should be.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "identification/regression/candidate.h"
#include "simulation/drives/drives.h"
#include "symbolic/extension/driven_model.h"

namespace sinew::diagnosis {

class EffortModel {
 public:
  /// `runtime`: folder of the runtime's headers. Throws std::runtime_error where the emitted C does
  /// not compile.
  EffortModel(const DrivenModel& model, const Identified& identified,
              const std::filesystem::path& runtime);

  /// samples x joints. The recording needs q, qd, qdd, time; missing load, "jerk" and "jounce" are
  /// zero. What a payload of known mass asks for is added as it is along the logged motion.
  Eigen::MatrixXd operator()(const Recording& log) const;

  /// The same for another motion, for derivatives with respect to it.
  Eigen::MatrixXd operator()(const Recording& log, const Eigen::MatrixXd& q,
                             const Eigen::MatrixXd& qd, const Eigen::MatrixXd& qdd) const;

  /// One joint's effort alone, for another motion: of a motor in little time.
  Eigen::VectorXd of_joint(int joint, const Recording& log, const Eigen::MatrixXd& q,
                           const Eigen::MatrixXd& qd, const Eigen::MatrixXd& qdd) const;

  /// What moves under given efforts, as they are logged. Throws as the constructor does.
  Drives drives() const;

  /// Operations of the emitted function.
  int operations() const { return operations_; }

 private:
  Eigen::MatrixXd run(const std::string& function, const Recording& log, const Eigen::MatrixXd& q,
                      const Eigen::MatrixXd& qd, const Eigen::MatrixXd& qdd) const;

  DrivenModel model_;
  Identified identified_;
  std::filesystem::path runtime_;
  int joints_;
  int operations_ = 0;
  std::vector<bool> motor_;
  std::shared_ptr<CompiledModel> compiled_;
};

}  // namespace sinew::diagnosis
