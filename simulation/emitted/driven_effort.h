// SPDX-License-Identifier: GPL-3.0-or-later
// The emitted effort of driven joints (symbolic/extension/driven_model.h), compiled and called at
// one instant after the other.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "simulation/emitted/compiled_model.h"
#include "symbolic/extension/driven_model.h"

namespace sinew {

/// Where an input of the emitted function comes from.
enum class EffortInput { q, qd, qdd, load, tension, jerk, jounce, time, step, memory };

/// Its numbers among all inputs.
struct EffortSlot {
  EffortInput input;
  Eigen::Index at = 0, count = 0;
};

/// Of an emitted effort, in the order of its arguments. Throws std::out_of_range for an argument
/// that no effort has.
std::vector<EffortSlot> effort_slots(const sinew_function& function);

/// What acts through the instants before, from one to the next.
struct EffortPast {
  Eigen::VectorXd memory;              ///< of the effects that have one
  Eigen::VectorXd acceleration, jerk;  ///< of the last instant; empty before the first
};

/// The effort at one instant after the other, a step apart. Higher derivatives of the motion are
/// backward differences over the steps. Copies share the compiled function.
class DrivenEffort {
 public:
  /// Throws std::runtime_error where the emitted C does not compile, std::invalid_argument for an
  /// effect at a place that the model has not.
  DrivenEffort(const DrivenModel& model, const Identified& identified,
               const std::filesystem::path& runtime);
  /// Of a model that is compiled already. Throws std::runtime_error where it has no effort.
  explicit DrivenEffort(std::shared_ptr<const CompiledModel> compiled);

  int joints() const { return joints_; }
  /// Some effect acts through the instants before: the effort is one of steps, not of time.
  bool has_past() const;

  void set_time(double seconds) { set(EffortInput::time, seconds); }
  void set_step(double seconds);
  /// External load against each joint [N·m, N]; force of each tendon [N]. Empty: none.
  void set_load(const Eigen::VectorXd& load) { set(EffortInput::load, load); }
  void set_tension(const Eigen::VectorXd& tension) { set(EffortInput::tension, tension); }

  /// Effort of each joint [N·m, N] for a motion. The past stays as it was.
  Eigen::VectorXd operator()(const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                             const Eigen::VectorXd& qdd);
  /// The motion given last becomes the past.
  void remember();

  /// There is no past: nothing has moved.
  void forget();
  const EffortPast& past() const { return past_; }
  void set_past(const EffortPast& past) { past_ = past; }

 private:
  void set(EffortInput input, double value);
  void set(EffortInput input, const Eigen::VectorXd& values);
  const EffortSlot* slot(EffortInput input) const;
  void take_derivatives(const Eigen::VectorXd& qdd);

  std::shared_ptr<const CompiledModel> compiled_;
  const sinew_function* function_;
  int joints_;
  std::vector<EffortSlot> slots_;
  double step_ = 1e-3;  ///< s
  EffortPast past_;
  Eigen::VectorXd in_, out_, qdd_, jerk_;
};

}  // namespace sinew
