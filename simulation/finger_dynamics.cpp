// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/finger_dynamics.h"

#include <algorithm>

#include "generator/assemble.h"
#include "simulation/stored_energy.h"
#include "symbolic/coordinates.h"
#include "symbolic/functions.h"
#include "symbolic/symbols.h"

namespace sinew {
namespace {

/// All moving joints as the coordinates have them, couplings and four-bars included, and J.
Function moving_joints(const Mechanism& mechanism) {
  const Argument q = joint_positions(mechanism);
  const auto n = q.symbols.size();
  DefinitionList list;
  const JointMap joints = Coordinates(mechanism).at(list, {q.symbols.begin(), q.symbols.end()});
  const std::vector<GiNaC::ex> positions = joints.positions();
  std::vector<GiNaC::ex> J(positions.size() * n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<GiNaC::ex> unit(n, 0);
    unit[k] = 1;
    const std::vector<GiNaC::ex> column = joints.velocities(unit);
    for (std::size_t i = 0; i < column.size(); ++i) J[i * n + k] = column[i];
  }
  const int rows = static_cast<int>(positions.size());
  return {"moving_joints",
          "Positions of all moving joints, and their derivatives by the coordinates.",
          "(5.16)",
          {q},
          list.items(),
          {{"positions", rows, 1, positions, "rad", "metres where a joint slides"},
           {"J", rows, static_cast<int>(n), J, "1", "d(positions)/dq"}}};
}

CompiledModel compiled(const Mechanism& mechanism, bool turning_gravity,
                       const std::filesystem::path& runtime) {
  std::vector<Function> functions = functions_of(mechanism, emitted_cost, turning_gravity);
  functions.push_back(moving_joints(mechanism));
  return CompiledModel(assemble({mechanism.name, mechanism.description, "", {}}, functions, {}),
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

/// Of each coordinate; joints that follow another add to its own.
Eigen::VectorXd damping_of(const Mechanism& mechanism, const CompiledModel& model) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<double> each;
  for (const Joint& joint : mechanism.joints)
    if (joint.type != JointType::fixed) each.push_back(joint.damping);
  const auto joints = static_cast<Eigen::Index>(each.size());
  const Eigen::Map<Eigen::VectorXd> d(each.data(), joints);
  const Coordinates coordinates(mechanism);
  const auto n = static_cast<std::size_t>(coordinates.count());
  if (!coordinates.linear() && (d.array() != 0.0).any())
    throw std::invalid_argument(mechanism.name +
                                ": damping of joints in a mechanism with a four-bar is not "
                                "simulated; set it to zero");
  const std::vector<double> at_zero = model("moving_joints", std::vector<double>(n, 0.0));
  const Eigen::Map<const RowMajor> J(at_zero.data() + joints, joints, static_cast<Eigen::Index>(n));
  return (J.transpose() * d.asDiagonal() * J).diagonal();
}

}  // namespace

FingerDynamics::FingerDynamics(const Mechanism& mechanism, bool turning_gravity,
                               const std::filesystem::path& runtime)
    : mechanism_(mechanism),
      model_(compiled(mechanism, turning_gravity, runtime)),
      n_(static_cast<std::size_t>(Coordinates(mechanism).count())),
      damping_(damping_of(mechanism, model_)) {
  joints_ = &model_.find("moving_joints");
  if (turning_gravity) parameters_ = model_("base_parameters", mass_properties(mechanism));
  acceleration_ = &model_.find("forward_dynamics");
  mass_and_bias_ = &model_.find("mass_matrix_and_bias");
  if (!mechanism.tendons.empty()) bending_ = &model_.find("bending_angles");
  for (const sinew_function* function : {acceleration_, mass_and_bias_, joints_})
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
  double joints[kMostNumbers];  // positions, then J
  joints_->call(q, joints);
  return gravity_potential(mechanism_, joints, gravity);
}

void FingerDynamics::bending(const double* q, double* angle) const {
  if (bending_ != nullptr) bending_->call(q, angle);
}

}  // namespace sinew
