// SPDX-License-Identifier: GPL-3.0-or-later
// Reference numerics of tendon lengths, moment arms and joint stiffness.
#pragma once

#include <vector>

#include "tests/reference/chain.h"

namespace sinew::reference {

/// h(q) of every tendon and its derivatives; h0 + pulleys (5.5) + straight stretches (5.20).
template <class Scalar>
class TendonPaths {
 public:
  using Vector = VectorX<Scalar>;
  using Matrix = MatrixX<Scalar>;

  /// Throws std::invalid_argument where a tendon names a joint or body that does not exist.
  explicit TendonPaths(const Mechanism& mechanism);

  int size() const { return static_cast<int>(tendons_.size()); }
  /// m lengths [m].
  Vector lengths(const Vector& q) const;
  /// m x n, P = dh/dq.
  Matrix coupling_matrix(const Vector& q) const;
  /// n x n second derivative of one tendon's length.
  Matrix length_hessian(const Vector& q, int tendon) const;
  /// tau = -P^T f, f: m tendon forces [N].
  Vector joint_torque(const Vector& q, const Vector& f) const;
  /// K = sum_i f_i d2h_i/dq2 + P^T diag(kt) P; kt: m tendon stiffnesses [N/m].
  Matrix joint_stiffness(const Vector& q, const Vector& f, const Vector& kt) const;
  /// Least-squares q with h(q) = h for constant radii: (P^T P)^-1 P^T (h - h(0)).
  Vector link_position(const Vector& h) const;

 private:
  struct Straight {
    int from_body, to_body;
    Vector3<Scalar> from, to;
  };
  struct Tendon {
    Scalar h0;
    Vector radii;  ///< n
    std::vector<Straight> straights;
  };
  /// A stretch's vector from its first to its second point, and derivatives, base frame.
  struct Stretch {
    Vector3<Scalar> span;
    Matrix jacobian;
  };
  Stretch stretch(const std::vector<Pose<Scalar>>& poses, const Straight& straight) const;
  Vector3<Scalar> place(const std::vector<Pose<Scalar>>& poses, int body,
                        const Vector3<Scalar>& point) const;

  Chain<Scalar> chain_;
  std::vector<Tendon> tendons_;
};

extern template class TendonPaths<double>;
extern template class TendonPaths<long double>;
extern template class TendonPaths<Real50>;

}  // namespace sinew::reference
