// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "simulation/bodies/finger_dynamics.h"
#include "simulation/bodies/joints.h"
#include "symbolic/dynamics/coordinates.h"

namespace sinew {
namespace {

class Finger : public Joints {
 public:
  Finger(const Mechanism& mechanism, const std::filesystem::path& runtime)
      : dynamics_(mechanism, false, runtime), gravity_(mechanism.gravity) {
    const Coordinates coordinates(mechanism);
    for (const int index : coordinates.joints()) {
      const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
      names.push_back(joint.name);
      slides.push_back(joint.type == JointType::prismatic);
    }
    damping = dynamics_.damping();
    rest = Eigen::VectorXd::Zero(size());
    tendons = dynamics_.tendons();
    n_ = names.size();
    m_ = mechanism.tendons.size();
    jacobian_ = &dynamics_.model().find("tip_jacobian");
  }

  void lengths(const double* q, const WristMotion&, double* h) const override {
    dynamics_.lengths(q, h);
  }
  void torque(const double* q, const WristMotion&, const double* f, double* tau) const override {
    dynamics_.torque(q, f, tau);
  }
  void coupling(const double* q, const WristMotion&, double* P, double* wrist_rate) const override {
    dynamics_.coupling(q, P);
    std::fill(wrist_rate, wrist_rate + m_, 0.0);
  }
  void stiffness(const double* q, const WristMotion&, const double* f, const double* kt,
                 double* K) const override {
    dynamics_.stiffness(q, f, kt, K);
  }
  void acceleration(const double* q, const double* qd, const WristMotion&, const double* tau,
                    double* qdd) const override {
    dynamics_.acceleration(q, qd, tau, nullptr, qdd);
  }
  void inertial_forces(const double* q, const double* qd, const double* qdd, const WristMotion&,
                       double* tau) const override {
    dynamics_.inverse(q, qd, qdd, nullptr, tau, nullptr);
  }
  void mass_matrix(const double* q, const WristMotion&, double* M) const override {
    dynamics_.mass_matrix(q, M);
  }
  void bending(const double* q, const WristMotion&, double* angle) const override {
    dynamics_.bending(q, angle);
  }
  void tip_torque(const double* q, const double* force, double* tau) const override {
    double J[kMostNumbers];
    jacobian_->call(q, J);
    for (std::size_t j = 0; j < n_; ++j)
      tau[j] = J[j] * force[0] + J[n_ + j] * force[1] + J[2 * n_ + j] * force[2];
  }
  double energy(const double* q, const double* qd, const WristMotion&) const override {
    return dynamics_.energy(q, qd, {}, gravity_);
  }
  double base_power(const double*, const double*, const double*,
                    const WristMotion&) const override {
    return 0.0;
  }

 private:
  FingerDynamics dynamics_;
  Eigen::Vector3d gravity_;
  std::size_t n_ = 0, m_ = 0;
  const sinew_function* jacobian_ = nullptr;
};

}  // namespace

std::unique_ptr<Joints> finger_joints(const Mechanism& mechanism,
                                      const std::filesystem::path& runtime) {
  return std::make_unique<Finger>(mechanism, runtime);
}

}  // namespace sinew
