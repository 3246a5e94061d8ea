// SPDX-License-Identifier: GPL-3.0-or-later
// The jointed bodies that a simulation moves: one finger, or all of a hand.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/emitted/compiled_model.h"
#include "symbolic/hand/hand.h"

namespace sinew {

/// Prescribed bar angles of the wrist, their rates and accelerations; ignored by a single finger.
struct WristMotion {
  double q[2] = {0.0, 0.0};    ///< q71, q73 [rad]
  double qd[2] = {0.0, 0.0};   ///< rad/s
  double qdd[2] = {0.0, 0.0};  ///< rad/s²
};

/// n coordinates, m tendons; arrays row-major, SI units. Right-hand sides come from emitted C.
class Joints {
 public:
  virtual ~Joints() = default;

  std::vector<std::string> names;  ///< of the coordinates
  std::vector<bool> slides;        ///< n, m instead of rad
  Eigen::VectorXd damping;         ///< n, viscous [N·m·s/rad or N·s/m]
  Eigen::VectorXd rest;            ///< n, where they start unless told otherwise [rad or m]
  int tendons = 0;

  int size() const { return static_cast<int>(names.size()); }
  /// Path lengths [m].
  virtual void lengths(const double* q, const WristMotion& wrist, double* h) const = 0;
  /// -P^T f on the coordinates [N·m].
  virtual void torque(const double* q, const WristMotion& wrist, const double* f,
                      double* tau) const = 0;
  /// P = dh/dq, m x n, and `wrist_rate` = the wrist's share of dh/dt [m/s] (m).
  virtual void coupling(const double* q, const WristMotion& wrist, double* P,
                        double* wrist_rate) const = 0;
  /// Stiffness with the motors held, n x n.
  virtual void stiffness(const double* q, const WristMotion& wrist, const double* f,
                         const double* kt, double* K) const = 0;
  virtual void acceleration(const double* q, const double* qd, const WristMotion& wrist,
                            const double* tau, double* qdd) const = 0;
  /// Torques that a motion takes, by the emitted inverse dynamics; `qdd` n.
  virtual void inertial_forces(const double* q, const double* qd, const double* qdd,
                               const WristMotion& wrist, double* tau) const = 0;
  /// Mass matrix n x n.
  virtual void mass_matrix(const double* q, const WristMotion& wrist, double* M) const = 0;
  /// Total bending of each tendon at joints and wrist [rad].
  virtual void bending(const double* q, const WristMotion& wrist, double* angle) const = 0;
  /// Torque of a force [N, base frame] at the fingertip; 0 where the model has no single tip.
  virtual void tip_torque(const double* q, const double* force, double* tau) const = 0;
  /// Kinetic energy of all that moves, the base's motion included, and potential of gravity [J],
  /// from geometry.
  virtual double energy(const double* q, const double* qd, const WristMotion& wrist) const = 0;
  /// Power [W] that a prescribed motion of the base gives to the bodies.
  virtual double base_power(const double* q, const double* qd, const double* qdd,
                            const WristMotion& wrist) const = 0;
};

/// One finger, or any mechanism, on a resting base.
std::unique_ptr<Joints> finger_joints(const Mechanism& mechanism,
                                      const std::filesystem::path& runtime);

/// What of a hand moves besides its fingers.
struct PalmParameters {
  double crank_inertia = 2.0e-5;  ///< kg·m², of what the four-bar's crank moves besides the finger
  bool moves = false;             ///< q71 and q73 are coordinates, the last two, instead of given
  double inertia = 2.0e-3;        ///< kg·m², of bars and palm about q71 and about q73
  double damping = 1.0e-2;        ///< N·m·s/rad, of q71 and of q73
  std::optional<Eigen::Vector3d> gravity = {};  ///< m/s², forearm frame, instead of the hand's
};

/// All fingers of a hand on a moving palm, which they feel with all its accelerations. A palm that
/// moves freely, and the four-bar's crank, feel the fingers in turn; a palm's own weight does not
/// count. `gravity` in the forearm frame [m/s²].
std::unique_ptr<Joints> hand_joints(const Hand& hand, const Eigen::Vector3d& gravity,
                                    const PalmParameters& palm,
                                    const std::filesystem::path& runtime);

/// The same hand, not derived again. Throws std::invalid_argument for anything but a hand.
std::unique_ptr<Joints> on_other_palm(const Joints& hand, const PalmParameters& palm);

}  // namespace sinew
