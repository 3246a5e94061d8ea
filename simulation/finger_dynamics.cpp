// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/finger_dynamics.h"

#include <algorithm>

#include "generator/assemble.h"
#include "simulation/stored_energy.h"
#include "symbolic/functions.h"

namespace sinew {
namespace {

CompiledModel compiled(const Mechanism& mechanism, bool turning_gravity,
                       const std::filesystem::path& runtime) {
  return CompiledModel(assemble({mechanism.name, mechanism.description, "", {}},
                                functions_of(mechanism, emitted_cost, turning_gravity), {}),
                       runtime);
}

/// Arguments of base_parameters: mass, centre of mass, inertia (xx, yy, zz, xy, xz, yz), gravity.
std::vector<double> mass_properties(const Mechanism& mechanism) {
  std::vector<double> mass, centre, inertia;
  for (const Body& body : mechanism.bodies) {
    mass.push_back(body.mass);
    for (int i = 0; i < 3; ++i) centre.push_back(body.centre_of_mass(i));
    const Eigen::Matrix3d& I = body.inertia;
    inertia.insert(inertia.end(), {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)});
  }
  mass.insert(mass.end(), centre.begin(), centre.end());
  mass.insert(mass.end(), inertia.begin(), inertia.end());
  for (int i = 0; i < 3; ++i) mass.push_back(mechanism.gravity(i));
  return mass;
}

Eigen::VectorXd damping_of(const Mechanism& mechanism, const Eigen::MatrixXd& motion) {
  std::vector<double> each;
  for (const Joint& joint : mechanism.joints)
    if (joint.type != JointType::fixed) each.push_back(joint.damping);
  const Eigen::Map<Eigen::VectorXd> d(each.data(), static_cast<Eigen::Index>(each.size()));
  // Only the diagonal: joints that follow another add to its own damping.
  return (motion.transpose() * d.asDiagonal() * motion).diagonal();
}

}  // namespace

FingerDynamics::FingerDynamics(const Mechanism& mechanism, bool turning_gravity,
                               const std::filesystem::path& runtime)
    : mechanism_(mechanism),
      model_(compiled(mechanism, turning_gravity, runtime)),
      motion_(joint_motion_matrix(mechanism)),
      damping_(damping_of(mechanism, motion_)) {
  n_ = static_cast<std::size_t>(motion_.cols());
  if (turning_gravity) parameters_ = model_("base_parameters", mass_properties(mechanism));
  acceleration_ = &model_.find("forward_dynamics");
  mass_and_bias_ = &model_.find("mass_matrix_and_bias");
  if (!mechanism.tendons.empty()) bending_ = &model_.find("bending_angles");
  for (const sinew_function* function : {acceleration_, mass_and_bias_})
    if (function->input_size > static_cast<int>(kMostNumbers) ||
        function->output_size > static_cast<int>(kMostNumbers))
      throw std::runtime_error(mechanism.name + ": too many joints to simulate");
}

std::size_t FingerDynamics::put_parameters(const double* gravity, double* in) const {
  if (parameters_.empty()) return 0;
  std::copy(parameters_.begin(), parameters_.end(), in);
  std::copy(gravity, gravity + 3, in);
  return parameters_.size();
}

void FingerDynamics::acceleration(const double* q, const double* qd, const double* gravity,
                                  const double* tau, double* qdd) const {
  double in[kMostNumbers];
  std::copy(q, q + n_, in);
  std::copy(qd, qd + n_, in + n_);
  std::copy(tau, tau + n_, in + 2 * n_);
  put_parameters(gravity, in + 3 * n_);
  acceleration_->call(in, qdd);
}

void FingerDynamics::mass_and_bias(const double* q, const double* qd, const double* gravity,
                                   double* M, double* bias) const {
  double in[kMostNumbers], out[kMostNumbers];
  std::copy(q, q + n_, in);
  std::copy(qd, qd + n_, in + n_);
  put_parameters(gravity, in + 2 * n_);
  mass_and_bias_->call(in, out);
  std::copy(out, out + n_ * n_, M);
  std::copy(out + n_ * n_, out + n_ * n_ + n_, bias);
}

double FingerDynamics::potential(const double* q, const Eigen::Vector3d& gravity) const {
  const Eigen::VectorXd joints =
      motion_ * Eigen::Map<const Eigen::VectorXd>(q, static_cast<Eigen::Index>(n_));
  return gravity_potential(mechanism_, joints.data(), gravity);
}

void FingerDynamics::bending(const double* q, double* angle) const {
  if (bending_ != nullptr) bending_->call(q, angle);
}

}  // namespace sinew
