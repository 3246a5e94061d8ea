// SPDX-License-Identifier: GPL-3.0-or-later
// Recursive Newton-Euler dynamics of a tree of joints: the independent numerics that emitted C is
// compared with (the corrected (2.10) and its backward pass). No symbolic algebra, no shared code.
#pragma once

#include <vector>

#include "tests/reference/chain.h"

namespace sinew::reference {

/// M(q) qdd + C(q,qd) qd + g(q) = tau; instantiated for double, long double and Real50.
/// q [rad or m], qd, qdd: size() values each; torques [N m or N].
template <class Scalar>
class NewtonEuler {
 public:
  using Vector = VectorX<Scalar>;
  using Matrix = MatrixX<Scalar>;

  explicit NewtonEuler(const Mechanism& mechanism);

  int size() const { return chain_.coordinates(); }
  const Chain<Scalar>& chain() const { return chain_; }

  Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) const;
  /// C(q,qd) qd + g(q).
  Vector bias(const Vector& q, const Vector& qd) const;
  Vector gravity(const Vector& q) const;
  /// n x n, column j from a unit acceleration of joint j at rest without gravity.
  Matrix mass_matrix(const Vector& q) const;
  /// n x n in Christoffel form; see the definition for why differences of torques are exact here.
  Matrix coriolis_matrix(const Vector& q, const Vector& qd) const;
  /// qdd with M qdd = tau - bias.
  Vector forward_dynamics(const Vector& q, const Vector& qd, const Vector& tau) const;
  /// [J] kinetic energy of the bodies.
  Scalar kinetic_energy(const Vector& q, const Vector& qd) const;
  /// [J] -sum m gravity . centre of mass, base frame.
  Scalar potential_energy(const Vector& q) const;

  /// 4 x 4 pose of the mechanism's first frame in the base frame. Throws where there is none.
  Matrix forward_kinematics(const Vector& q) const;
  /// 6 x n: rows 0-2 the frame origin's velocity, rows 3-5 its angular velocity, base frame.
  Matrix tip_jacobian(const Vector& q) const;

 private:
  struct Inertial {
    Scalar mass;
    Vector3<Scalar> centre;
    Matrix3<Scalar> inertia;
  };
  /// Velocity and acceleration of a body's frame, in that frame.
  struct Twist {
    Vector3<Scalar> spin, spin_rate, acceleration;
  };
  using Poses = std::vector<Pose<Scalar>>;

  Vector torques(const Poses& relative, const Vector& qd, const Vector& qdd,
                 const Vector3<Scalar>& gravity) const;
  std::vector<Twist> outward(const Poses& relative, const Vector& qd, const Vector& qdd,
                             const Vector3<Scalar>& gravity) const;
  const Pose<Scalar>& tip() const;

  Chain<Scalar> chain_;
  std::vector<Inertial> bodies_;
  Vector3<Scalar> gravity_;
  int tip_body_ = -1;
  std::vector<Pose<Scalar>> tip_pose_;  ///< empty where the mechanism names no frame
};

extern template class NewtonEuler<double>;
extern template class NewtonEuler<long double>;
extern template class NewtonEuler<Real50>;

}  // namespace sinew::reference
