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
#include "simulation/compiled_model.h"
#include "symbolic/extension/driven_model.h"

namespace sinew::diagnosis {

/// Where an input of the emitted function comes from.
enum class EffortInput { q, qd, qdd, load, tension, jerk, jounce, time, step, memory };

/// Its numbers among all inputs.
struct EffortSlot {
  EffortInput input;
  Eigen::Index at = 0, count = 0;
};

class EffortModel {
 public:
  /// `runtime`: folder of the runtime's headers. Throws std::runtime_error where the emitted C does
  /// not compile.
  EffortModel(const DrivenModel& model, const Identified& identified,
              const std::filesystem::path& runtime);

  /// samples x joints. The recording needs q, qd, qdd, time; missing load, "jerk" and "jounce" are
  /// zero.
  Eigen::MatrixXd operator()(const Recording& log) const;

  /// The same for another motion, for derivatives with respect to it.
  Eigen::MatrixXd operator()(const Recording& log, const Eigen::MatrixXd& q,
                             const Eigen::MatrixXd& qd, const Eigen::MatrixXd& qdd) const;

  /// One joint's effort alone, for another motion: of a motor in little time.
  Eigen::VectorXd of_joint(int joint, const Recording& log, const Eigen::MatrixXd& q,
                           const Eigen::MatrixXd& qd, const Eigen::MatrixXd& qdd) const;

  /// Operations of the emitted function.
  int operations() const { return operations_; }

 private:
  friend class EffortAtInstant;
  Eigen::MatrixXd run(const std::string& function, const Recording& log, const Eigen::MatrixXd& q,
                      const Eigen::MatrixXd& qd, const Eigen::MatrixXd& qdd) const;

  int joints_;
  int operations_ = 0;
  std::vector<bool> motor_;
  std::shared_ptr<CompiledModel> compiled_;
};

/// The emitted effort at one instant after the other, for a motion of one's own. A copy goes on by
/// itself from where the original is.
class EffortAtInstant {
 public:
  explicit EffortAtInstant(const EffortModel& model);

  /// Takes all but the motion from a recording's sample.
  void take(const Recording& log, Eigen::Index sample);
  /// Effort of each joint for a motion; what effects remember stays as it was.
  Eigen::VectorXd operator()(const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                             const Eigen::VectorXd& qdd);
  /// Effects remember the last motion given.
  void remember();

 private:
  std::shared_ptr<CompiledModel> compiled_;
  const sinew_function* function_;
  Eigen::Index joints_;
  std::vector<EffortSlot> slots_;
  Eigen::VectorXd in_, out_;
};

}  // namespace sinew::diagnosis
