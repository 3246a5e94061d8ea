// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/bodies/body_energy.h"
#include "simulation/emitted/compiled_model.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// Numbers an emitted function may take or give: they are on the stack.
inline constexpr std::size_t kMostNumbers = 4096;

/// One finger's emitted equations: n coordinates, m tendons; arrays row-major, SI units.
class FingerDynamics {
 public:
  /// On a resting base the equations are those that `sinew generate` writes. With `moving_base`
  /// they are moving_base.h's, and gravity is part of the base's motion. Throws
  /// std::invalid_argument where a mechanism with a four-bar has damped joints.
  FingerDynamics(const Mechanism& mechanism, bool moving_base,
                 const std::filesystem::path& runtime);

  int size() const { return static_cast<int>(n_); }
  int tendons() const { return static_cast<int>(m_); }
  const CompiledModel& model() const { return model_; }
  const Eigen::VectorXd& damping() const { return damping_; }

  /// `base`: 9 numbers as moving_base.h has them; ignored where the base rests.
  void acceleration(const double* q, const double* qd, const double* tau, const double* base,
                    double* qdd) const;
  /// Joint torques of a motion; `wrench` (6) of the base where it moves, else untouched.
  void inverse(const double* q, const double* qd, const double* qdd, const double* base,
               double* tau, double* wrench) const;
  void mass_matrix(const double* q, double* M) const { mass_matrix_->call(q, M); }
  /// Kinetic and of gravity [J], from geometry; `gravity` in the frame at rest [m/s²].
  double energy(const double* q, const double* qd, const MovingFrame& base,
                const Eigen::Vector3d& gravity) const;

  // Of the tendons; to be called only where there are any.
  void lengths(const double* q, double* h) const { lengths_->call(q, h); }
  void coupling(const double* q, double* P) const { coupling_->call(q, P); }
  void torque(const double* q, const double* f, double* tau) const;
  void stiffness(const double* q, const double* f, const double* kt, double* K) const;
  /// Total bending of each tendon [rad].
  void bending(const double* q, double* angle) const { bending_->call(q, angle); }

 private:
  void find_functions(bool moving_base);

  CompiledModel model_;
  BodyEnergy bodies_;
  std::size_t n_ = 0, m_ = 0;
  bool moving_base_ = false;
  Eigen::VectorXd damping_;
  const sinew_function* joints_ = nullptr;
  const sinew_function* acceleration_ = nullptr;
  const sinew_function* inverse_ = nullptr;
  const sinew_function* mass_matrix_ = nullptr;
  const sinew_function* lengths_ = nullptr;
  const sinew_function* coupling_ = nullptr;
  const sinew_function* torque_ = nullptr;
  const sinew_function* stiffness_ = nullptr;
  const sinew_function* bending_ = nullptr;
};

}  // namespace sinew
