// SPDX-License-Identifier: GPL-3.0-or-later
// The fingers of a hand on what carries them: the palm, and the coupler of the four-bar.
//
// Carriers c = (theta2, q71, q73), theta2 only where there is a four-bar; the first `free` of them
// are coordinates behind the fingers', the others move as prescribed. Arrays of coordinates are in
// that order.
#pragma once

#include <array>
#include <vector>

#include "simulation/bodies/finger_dynamics.h"
#include "simulation/bodies/joints.h"

namespace sinew {

class FingerCarriers {
 public:
  /// `gravity` in the forearm frame [m/s²].
  FingerCarriers(const Hand& hand, const Eigen::Vector3d& gravity,
                 const std::filesystem::path& runtime);

  const std::vector<FingerDynamics>& fingers() const { return fingers_; }
  void put_on(const PalmParameters& palm);

  // As Joints has them.
  void acceleration(const double* q, const double* qd, const WristMotion& wrist, const double* tau,
                    double* qdd) const;
  void inertial_forces(const double* q, const double* qd, const double* qdd,
                       const WristMotion& wrist, double* tau) const;
  void mass_matrix(const double* q, const WristMotion& wrist, double* M) const;
  double energy(const double* q, const double* qd, const WristMotion& wrist) const;
  double base_power(const double* q, const double* qd, const double* qdd,
                    const WristMotion& wrist) const;

 private:
  static constexpr std::size_t most_carriers = 3;
  static constexpr std::size_t motion_size = 9, twist_size = 6;
  using Triple = std::array<double, most_carriers>;
  using Wrench = std::array<double, twist_size>;

  /// What a unit acceleration of one carrier does, all else at rest and without gravity.
  struct Response {
    std::vector<double> twist;   ///< fingers x 6: what the unit does to the bases
    std::vector<double> joints;  ///< accelerations or torques, one a coordinate of the fingers
    std::vector<Wrench> wrench;  ///< one a finger
  };

  /// Free carriers' values from `free_values`, the others' from `wrist`.
  Triple carriers(const double* free_values, const double* wrist) const;
  /// Of a free carrier without the fingers [kg·m²].
  double own_inertia(std::size_t carrier) const {
    return carrier + 2 < count_ ? palm_.crank_inertia : palm_.inertia;
  }
  bool carries(std::size_t carrier, std::size_t finger) const;
  std::size_t coordinates() const { return joints_ + free_; }

  void find_base_motion(const Triple& c, const Triple& rate, const Triple& acceleration) const;
  void find_twists(const Triple& c, const Triple& rate, double* twist) const;
  /// Inverse dynamics of the fingers under the bases' motion found last: of all, or of those on
  /// carriers that are free.
  void find_forces(const double* q, const double* qd, const double* qdd, double* tau,
                   bool freely_carried) const;
  /// Forces and wrenches of a motion, kept for the one asked for last.
  void find_motion_forces(const double* q, const double* qd, const double* qdd,
                          const WristMotion& wrist) const;
  /// With the joints free, or held where `joints_held`.
  void find_responses(const double* q, const Triple& c, bool joints_held) const;
  /// Power that wrenches of the bases give to a twist [W].
  double power(const std::vector<Wrench>& wrench, const double* twist) const;

  CompiledModel bases_;
  std::vector<FingerDynamics> fingers_;
  std::vector<bool> on_coupler_;
  Eigen::Vector3d gravity_;
  PalmParameters palm_;
  std::size_t joints_ = 0;  ///< coordinates of all fingers
  std::size_t count_ = 0;   ///< carriers
  std::size_t free_ = 0;
  const sinew_function* pose_ = nullptr;
  const sinew_function* twist_ = nullptr;
  const sinew_function* motion_ = nullptr;
  // For one call after the other.
  mutable std::vector<double> in_, base_, held_, poses_, twists_;
  mutable std::vector<double> forces_, asked_, known_;
  mutable bool forces_known_ = false;  ///< for the motion `known_`, with wrench_
  mutable std::vector<Wrench> wrench_;
  mutable std::array<Response, most_carriers> response_;
};

}  // namespace sinew
