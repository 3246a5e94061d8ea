// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/compiled_model.h"
#include "symbolic/mechanism.h"

namespace sinew {

/// Numbers an emitted function may take or give: they are on the stack.
inline constexpr std::size_t kMostNumbers = 4096;

/// One finger's emitted equations of motion under a gravity that may turn.
class FingerDynamics {
 public:
  /// With `turning_gravity` gravity and masses are arguments of the emitted C; otherwise they are
  /// constants, as in the C that `sinew generate` writes. Throws std::invalid_argument where a
  /// mechanism with a four-bar has damped joints.
  FingerDynamics(const Mechanism& mechanism, bool turning_gravity,
                 const std::filesystem::path& runtime);

  int size() const { return static_cast<int>(n_); }
  const CompiledModel& model() const { return model_; }
  const Eigen::VectorXd& damping() const { return damping_; }
  /// `gravity` in the finger's base frame [m/s²]; ignored where it is constant.
  void acceleration(const double* q, const double* qd, const double* gravity, const double* tau,
                    double* qdd) const;
  void mass_and_bias(const double* q, const double* qd, const double* gravity, double* M,
                     double* bias) const;
  double potential(const double* q, const Eigen::Vector3d& gravity) const;
  /// Of each tendon [rad], as the emitted bending_angles gives it.
  void bending(const double* q, double* angle) const;

 private:
  std::size_t put_parameters(const double* gravity, double* in) const;

  Mechanism mechanism_;
  CompiledModel model_;
  std::size_t n_ = 0;
  Eigen::VectorXd damping_;
  std::vector<double> parameters_;
  const sinew_function* joints_ = nullptr;
  const sinew_function* acceleration_ = nullptr;
  const sinew_function* mass_and_bias_ = nullptr;
  const sinew_function* bending_ = nullptr;  ///< none without tendons
};

}  // namespace sinew
