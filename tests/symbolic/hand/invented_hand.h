// SPDX-License-Identifier: GPL-3.0-or-later
// Robots that no folder of models holds: a claw that uses every routing primitive at once, with
// random numbers, and independent numerics of it.
#pragma once

#include <random>
#include <string>

#include "symbolic/model/mechanism.h"
#include "tests/reference/scalar.h"

namespace sinew_tests {

/// mechanism.toml and mass_properties.csv of a claw: a finger whose last joint a four-bar's coupler
/// drives, a thumb whose last joint a tendon loop drives, a link that a four-bar's rocker drives;
/// pulleys of either sign, straight stretches between fixed and moving points and between two
/// moving bodies.
struct InventedHand {
  std::string toml, csv;
};
InventedHand invented_hand(std::mt19937& random);

/// Dynamics and tendons of a mechanism with couplings, from the same mechanism without them: the
/// joints' motion is found from each linkage's triangles and differentiated by differences, with 50
/// digits.
class CoupledReference {
 public:
  using Real = sinew::reference::Real50;
  using Vector = sinew::reference::VectorX<Real>;
  using Matrix = sinew::reference::MatrixX<Real>;

  explicit CoupledReference(const sinew::Mechanism& mechanism);

  int size() const { return static_cast<int>(independent_.size()); }
  /// Positions of all moving joints.
  Vector joints(const Vector& q) const;
  /// Their derivative by the coordinates, and its rate along qd.
  Matrix motion(const Vector& q) const;
  Matrix motion_rate(const Vector& q, const Vector& qd) const;

  Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) const;
  Matrix mass_matrix(const Vector& q) const;
  Vector lengths(const Vector& q) const;
  /// dh/dq by differences of the lengths: what virtual work says.
  Matrix coupling_matrix(const Vector& q) const;
  /// d2U/dq2 by differences, of tendons with force f and stiffness kt at q.
  Matrix stiffness(const Vector& q, const Vector& f, const Vector& kt) const;
  /// Second derivatives of the lengths, a row a tendon.
  Matrix hessians(const Vector& q) const;
  Matrix tip_pose(const Vector& q) const;
  Matrix tip_jacobian(const Vector& q) const;

 private:
  Real linked(const sinew::FourBarCoupling& bars, const Real& crank) const;

  sinew::Mechanism whole_, open_;
  std::vector<std::size_t> independent_;  ///< moving joint of each coordinate
};

}  // namespace sinew_tests
