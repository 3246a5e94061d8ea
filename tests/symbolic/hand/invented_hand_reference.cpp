// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include "tests/reference/newton_euler.h"
#include "tests/reference/tendon_paths.h"
#include "tests/symbolic/hand/invented_hand.h"

namespace sinew_tests {

using namespace sinew;
using Real = CoupledReference::Real;
using Vector = CoupledReference::Vector;
using Matrix = CoupledReference::Matrix;
using reference::NewtonEuler;
using reference::TendonPaths;

namespace {

Mechanism opened(Mechanism mechanism) {
  mechanism.couplings.clear();
  mechanism.four_bars.clear();
  return mechanism;
}

std::size_t moving_index(const Mechanism& mechanism, const std::string& name) {
  const std::vector<int> moving = coordinate_of_joint(mechanism);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    if (mechanism.joints[i].name == name) return static_cast<std::size_t>(moving[i]);
  throw std::out_of_range(name);
}

/// Coupler and rocker angle at a crank angle, from the two triangles that the diagonal between the
/// crank's end and the rocker's pivot makes: not the equation that the derivation solves.
struct Angles {
  Real coupler, rocker;
};

Angles assembled(const FourBarCoupling& bars, const Real& theta) {
  const Real g = bars.ground, a = bars.crank, b = bars.coupler, c = bars.rocker;
  const Real dx = g - a * cos(theta), dy = -a * sin(theta), d = sqrt(dx * dx + dy * dy);
  const Real turn = acos((b * b + d * d - c * c) / (2 * b * d));
  // Open, for a crank turned to positive angles: coupler and rocker meet above the diagonal.
  const Real coupler = atan2(dy, dx) + (bars.branch < 0 ? turn : Real(-turn));
  const Real x = a * cos(theta) + b * cos(coupler) - g, y = a * sin(theta) + b * sin(coupler);
  if (!(abs(x * x + y * y - c * c) < Real("1e-45"))) throw std::logic_error("the loop is open");
  return {coupler, atan2(y, x)};
}

/// A turn less than half a circle.
Real turned(const Real& angle) {
  return atan2(sin(angle), cos(angle));
}

}  // namespace

CoupledReference::CoupledReference(const Mechanism& mechanism)
    : whole_(mechanism), open_(opened(mechanism)) {
  for (const Joint& joint : mechanism.joints) {
    const auto follows = [&](const auto& each) { return each.dependent == joint.name; };
    if (joint.type != JointType::fixed &&
        std::none_of(mechanism.couplings.begin(), mechanism.couplings.end(), follows) &&
        std::none_of(mechanism.four_bars.begin(), mechanism.four_bars.end(), follows))
      independent_.push_back(moving_index(mechanism, joint.name));
  }
}

Real CoupledReference::linked(const FourBarCoupling& bars, const Real& crank) const {
  const Real start = bars.crank_angle;
  const Angles zero = assembled(bars, start), now = assembled(bars, start + crank);
  return bars.follows == FourBarCoupling::Follows::rocker
             ? turned(now.rocker - zero.rocker)
             : turned(now.coupler - zero.coupler - crank);
}

Vector CoupledReference::joints(const Vector& q) const {
  Vector all = Vector::Zero(coordinate_count(whole_));
  for (std::size_t k = 0; k < independent_.size(); ++k)
    all[Eigen::Index(independent_[k])] = q[Eigen::Index(k)];
  const auto at = [&](const std::string& joint) -> Real& {
    return all[Eigen::Index(moving_index(whole_, joint))];
  };
  for (const JointCoupling& loop : whole_.couplings)
    at(loop.dependent) = Real(loop.ratio) * at(loop.independent) + Real(loop.offset);
  for (const FourBarCoupling& bars : whole_.four_bars)
    at(bars.dependent) = linked(bars, at(bars.independent));
  return all;
}

namespace {

/// Central difference of any function of the coordinates, along `direction`; of 50 digits 25 are
/// left even when it is taken twice.
template <class Of>
auto slope(const Of& of, const Vector& q, const Vector& direction) {
  const Real step("1e-13");
  const Vector by = direction * step;
  return ((of(Vector(q + by)) - of(Vector(q - by))) / (2 * step)).eval();
}

template <class Of>
Matrix jacobian(const Of& of, const Vector& q) {
  Matrix J;
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const Vector column = slope(of, q, Vector(Vector::Unit(q.size(), k)));
    if (k == 0) J.resize(column.size(), q.size());
    J.col(k) = column;
  }
  return J;
}

}  // namespace

Matrix CoupledReference::motion(const Vector& q) const {
  return jacobian([this](const Vector& x) { return joints(x); }, q);
}

Matrix CoupledReference::motion_rate(const Vector& q, const Vector& qd) const {
  return slope([this](const Vector& x) { return motion(x); }, q, qd);
}

Vector CoupledReference::inverse_dynamics(const Vector& q, const Vector& qd,
                                          const Vector& qdd) const {
  const Matrix J = motion(q);
  return J.transpose() * NewtonEuler<Real>(open_).inverse_dynamics(
                             joints(q), J * qd, J * qdd + motion_rate(q, qd) * qd);
}

Matrix CoupledReference::mass_matrix(const Vector& q) const {
  const Matrix J = motion(q);
  return J.transpose() * NewtonEuler<Real>(open_).mass_matrix(joints(q)) * J;
}

Vector CoupledReference::lengths(const Vector& q) const {
  return TendonPaths<Real>(open_).lengths(joints(q));
}

Matrix CoupledReference::coupling_matrix(const Vector& q) const {
  return jacobian([this](const Vector& x) { return lengths(x); }, q);
}

Matrix CoupledReference::stiffness(const Vector& q, const Vector& f, const Vector& kt) const {
  const Vector h = lengths(q);
  return jacobian(
      [&](const Vector& x) {
        const Vector force = f + kt.cwiseProduct(lengths(x) - h);
        return Vector(coupling_matrix(x).transpose() * force);
      },
      q);
}

Matrix CoupledReference::hessians(const Vector& q) const {
  const Eigen::Index n = q.size();
  Matrix H;
  for (Eigen::Index k = 0; k < n; ++k) {
    const Matrix by_q = slope([this](const Vector& x) { return coupling_matrix(x); }, q,
                              Vector(Vector::Unit(n, k)));
    if (k == 0) H.resize(by_q.rows(), n * n);
    for (Eigen::Index j = 0; j < n; ++j) H.col(n * j + k) = by_q.col(j);
  }
  return H;
}

Matrix CoupledReference::tip_jacobian(const Vector& q) const {
  return NewtonEuler<Real>(open_).tip_jacobian(joints(q)) * motion(q);
}

Matrix CoupledReference::tip_pose(const Vector& q) const {
  return NewtonEuler<Real>(open_).forward_kinematics(joints(q));
}

}  // namespace sinew_tests
