// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/newton_euler.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <stdexcept>

#include "tests/reference/written_number.h"

namespace sinew::reference {
namespace {

int body_index(const Mechanism& mechanism, const std::string& name) {
  if (name == "base") return -1;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
    if (mechanism.bodies[i].name == name) return static_cast<int>(i);
  throw std::invalid_argument("no body named " + name);
}

}  // namespace

template <class Scalar>
NewtonEuler<Scalar>::NewtonEuler(const Mechanism& mechanism)
    : chain_(mechanism), gravity_(written_vector<Scalar>(mechanism.gravity)) {
  for (const Body& body : mechanism.bodies)
    bodies_.push_back({written_number<Scalar>(body.mass),
                       written_vector<Scalar>(body.centre_of_mass),
                       written_matrix<Scalar>(body.inertia)});
  if (mechanism.frames.empty()) return;
  const Frame& frame = mechanism.frames.front();
  tip_body_ = body_index(mechanism, frame.body);
  tip_pose_.push_back({exact_rotation<Scalar>(frame.pose.rotation),
                       written_vector<Scalar>(frame.pose.translation)});
}

template <class Scalar>
auto NewtonEuler<Scalar>::outward(const Poses& relative, const Vector& qd, const Vector& qdd,
                                  const Vector3<Scalar>& gravity) const -> std::vector<Twist> {
  const Twist base{Vector3<Scalar>::Zero(), Vector3<Scalar>::Zero(), -gravity};
  std::vector<Twist> twists;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const auto& joint = chain_.joints()[i];
    const Twist& parent = joint.parent < 0 ? base : twists[static_cast<std::size_t>(joint.parent)];
    const Vector3<Scalar>& p = relative[i].translation;
    const Matrix3<Scalar> to_child = relative[i].rotation.transpose();
    Twist own;
    own.spin = to_child * parent.spin;
    own.spin_rate = to_child * parent.spin_rate;
    own.acceleration = to_child * (parent.acceleration + parent.spin_rate.cross(p) +
                                   parent.spin.cross(parent.spin.cross(p)));
    if (joint.type == JointType::revolute) {
      const Vector3<Scalar> rate = joint.axis * qd[joint.coordinate];
      own.spin_rate += own.spin.cross(rate) + joint.axis * qdd[joint.coordinate];
      own.spin += rate;
    } else if (joint.type == JointType::prismatic) {
      const Vector3<Scalar> rate = joint.axis * qd[joint.coordinate];
      own.acceleration += Scalar(2) * own.spin.cross(rate) + joint.axis * qdd[joint.coordinate];
    }
    twists.push_back(own);
  }
  return twists;
}

template <class Scalar>
auto NewtonEuler<Scalar>::torques(const Poses& relative, const Vector& qd, const Vector& qdd,
                                  const Vector3<Scalar>& gravity) const -> Vector {
  const std::vector<Twist> twists = outward(relative, qd, qdd, gravity);
  std::vector<Vector3<Scalar>> force(bodies_.size(), Vector3<Scalar>::Zero());
  std::vector<Vector3<Scalar>> moment(bodies_.size(), Vector3<Scalar>::Zero());
  Vector tau = Vector::Zero(size());
  for (std::size_t i = bodies_.size(); i-- > 0;) {
    const Inertial& body = bodies_[i];
    const Twist& twist = twists[i];
    const Vector3<Scalar> centre_acceleration = twist.acceleration +
                                                twist.spin_rate.cross(body.centre) +
                                                twist.spin.cross(twist.spin.cross(body.centre));
    const Vector3<Scalar> inertial_force = body.mass * centre_acceleration;
    const Vector3<Scalar> spin_momentum = body.inertia * twist.spin;
    force[i] += inertial_force;
    moment[i] += body.centre.cross(inertial_force) + body.inertia * twist.spin_rate +
                 twist.spin.cross(spin_momentum);
    const auto& joint = chain_.joints()[i];
    if (joint.coordinate >= 0)
      tau[joint.coordinate] =
          joint.axis.dot(joint.type == JointType::revolute ? moment[i] : force[i]);
    if (joint.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(joint.parent);
    const Vector3<Scalar> passed = relative[i].rotation * force[i];
    force[parent] += passed;
    moment[parent] += relative[i].rotation * moment[i] + relative[i].translation.cross(passed);
  }
  return tau;
}

template <class Scalar>
auto NewtonEuler<Scalar>::inverse_dynamics(const Vector& q, const Vector& qd,
                                           const Vector& qdd) const -> Vector {
  return torques(chain_.relative_poses(q), qd, qdd, gravity_);
}

template <class Scalar>
auto NewtonEuler<Scalar>::bias(const Vector& q, const Vector& qd) const -> Vector {
  return inverse_dynamics(q, qd, Vector::Zero(size()));
}

template <class Scalar>
auto NewtonEuler<Scalar>::gravity(const Vector& q) const -> Vector {
  return inverse_dynamics(q, Vector::Zero(size()), Vector::Zero(size()));
}

template <class Scalar>
auto NewtonEuler<Scalar>::mass_matrix(const Vector& q) const -> Matrix {
  const Poses relative = chain_.relative_poses(q);
  const Vector rest = Vector::Zero(size());
  Matrix mass(size(), size());
  for (int j = 0; j < size(); ++j)
    mass.col(j) = torques(relative, rest, Vector::Unit(size(), j), Vector3<Scalar>::Zero());
  return mass;
}

/// The velocity torques c(u) are a quadratic form in u whose coefficients, made symmetric in the
/// two velocities, are the Christoffel symbols of the first kind. Its polar form
/// B(u,v) = (c(u+v) - c(u) - c(v)) / 2 is unique, so column j of the Christoffel matrix is
/// B(qd, e_j). No derivative of the mass matrix is taken.
template <class Scalar>
auto NewtonEuler<Scalar>::coriolis_matrix(const Vector& q, const Vector& qd) const -> Matrix {
  const Poses relative = chain_.relative_poses(q);
  const Vector none = Vector::Zero(size());
  const auto form = [&](const Vector& u) {
    return torques(relative, u, none, Vector3<Scalar>::Zero());
  };
  const Vector at_rate = form(qd);
  Matrix coriolis(size(), size());
  for (int j = 0; j < size(); ++j) {
    const Vector unit = Vector::Unit(size(), j);
    coriolis.col(j) = (form(qd + unit) - at_rate - form(unit)) / Scalar(2);
  }
  return coriolis;
}

template <class Scalar>
auto NewtonEuler<Scalar>::forward_dynamics(const Vector& q, const Vector& qd,
                                           const Vector& tau) const -> Vector {
  return mass_matrix(q).ldlt().solve(Vector(tau - bias(q, qd)));
}

template <class Scalar>
Scalar NewtonEuler<Scalar>::kinetic_energy(const Vector& q, const Vector& qd) const {
  const auto poses = chain_.base_poses(q);
  Scalar energy(0);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Vector3<Scalar> centre = poses[i] * bodies_[i].centre;
    const Vector3<Scalar> velocity = chain_.point_jacobian(poses, static_cast<int>(i), centre) * qd;
    const Vector3<Scalar> spin =
        poses[i].rotation.transpose() *
        Vector3<Scalar>(chain_.angular_jacobian(poses, static_cast<int>(i)) * qd);
    energy += (bodies_[i].mass * velocity.squaredNorm() +
               spin.dot(Vector3<Scalar>(bodies_[i].inertia * spin))) /
              Scalar(2);
  }
  return energy;
}

template <class Scalar>
Scalar NewtonEuler<Scalar>::potential_energy(const Vector& q) const {
  const auto poses = chain_.base_poses(q);
  Scalar energy(0);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    energy -= bodies_[i].mass * gravity_.dot(Vector3<Scalar>(poses[i] * bodies_[i].centre));
  return energy;
}

template <class Scalar>
const Pose<Scalar>& NewtonEuler<Scalar>::tip() const {
  if (tip_pose_.empty()) throw std::invalid_argument("the mechanism names no frame");
  return tip_pose_.front();
}

template <class Scalar>
auto NewtonEuler<Scalar>::forward_kinematics(const Vector& q) const -> Matrix {
  const auto poses = chain_.base_poses(q);
  const Pose<Scalar> pose =
      tip_body_ < 0 ? tip() : poses[static_cast<std::size_t>(tip_body_)] * tip();
  Matrix matrix = Matrix::Identity(4, 4);
  matrix.template topLeftCorner<3, 3>() = pose.rotation;
  matrix.template topRightCorner<3, 1>() = pose.translation;
  return matrix;
}

template <class Scalar>
auto NewtonEuler<Scalar>::tip_jacobian(const Vector& q) const -> Matrix {
  const auto poses = chain_.base_poses(q);
  const Vector3<Scalar> point = forward_kinematics(q).template topRightCorner<3, 1>();
  Matrix jacobian(6, size());
  jacobian.topRows(3) = chain_.point_jacobian(poses, tip_body_, point);
  jacobian.bottomRows(3) = chain_.angular_jacobian(poses, tip_body_);
  return jacobian;
}

template class NewtonEuler<double>;
template class NewtonEuler<long double>;
template class NewtonEuler<Real50>;

}  // namespace sinew::reference
