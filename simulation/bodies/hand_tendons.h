// SPDX-License-Identifier: GPL-3.0-or-later
// All tendons of a hand: through the wrist and along their finger, or around the crank's pulley.
//
// Coordinates: the fingers', the crank where there is a four-bar and, where told so, q71 and q73.
#pragma once

#include <limits>
#include <vector>

#include "simulation/bodies/finger_dynamics.h"
#include "symbolic/hand/hand.h"

namespace sinew {

class HandTendons {
 public:
  HandTendons(const Hand& hand, const std::vector<FingerDynamics>& fingers,
              const std::filesystem::path& runtime);

  int count() const { return static_cast<int>(m_); }
  /// h = h_wrist + h_finger (5.1) [m]; `bars`: q71, q73 [rad], here and below.
  void lengths(const double* q, const double* bars, double* h) const;
  /// -P^T f on fingers and crank [N·m].
  void torque(const double* q, const double* f, double* tau) const;
  /// -P^T f on q71, q73 [N·m].
  void wrist_torque(const double* bars, const double* f, double* tau) const;
  /// dh/dq, m x `columns`; the last two are the wrist's where `with_wrist`.
  void coupling(const double* q, const double* bars, std::size_t columns, bool with_wrist,
                double* P) const;
  /// What the wrist's motion adds to dh/dt [m/s].
  void wrist_rate(const double* bars, const double* rates, double* h_rate) const;
  /// columns x columns [N·m/rad].
  void stiffness(const double* q, const double* bars, const double* f, const double* kt,
                 std::size_t columns, bool with_wrist, double* K) const;
  /// Total bending of each tendon at joints and wrist [rad].
  void bending(const double* q, const double* bars, double* angle) const;

 private:
  struct Member {
    FingerDynamics finger;
    std::vector<int> channels;
    std::size_t first = 0, size = 0;  ///< of its coordinates
  };

  /// A function of the wrist's pose, which is asked for the same one again and again.
  struct Passed {
    const sinew_function* function = nullptr;
    mutable std::vector<double> values;
    mutable double pose[2] = {std::numeric_limits<double>::quiet_NaN(), 0.0};  ///< none yet
    const double* at(const double* bars) const;
  };

  void add_wrist_stiffness(const double* bars, const double* f, const double* kt,
                           std::size_t columns, double* K) const;

  CompiledModel wrist_;
  std::vector<Member> members_;
  std::vector<int> crank_channels_;
  std::size_t crank_ = 0;  ///< its coordinate
  std::size_t m_ = 0;
  Passed lengths_, jacobian_;
  const sinew_function* torque_ = nullptr;
  const sinew_function* stiffness_ = nullptr;
  const sinew_function* bending_ = nullptr;
  const sinew_function* crank_lengths_ = nullptr;
  const sinew_function* crank_coupling_ = nullptr;
  // For one call after the other.
  mutable std::vector<double> in_, P_;
};

}  // namespace sinew
