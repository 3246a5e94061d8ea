// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/bodies/finger_dynamics.h"

#include <algorithm>

#include "generator/assemble.h"
#include "simulation/bodies/moving_base.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/model/singular_mass_matrix.h"
#include "symbolic/tendons/functions.h"
#include "symbolic/tendons/tendon_bending.h"
#include "symbolic/tendons/tendon_functions.h"

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
          "Positions of all moving joints, and their derivatives by the "
          "coordinates.",
          "(5.16)",
          {q},
          list.items(),
          {{"positions", rows, 1, positions, "rad", "metres where a joint slides"},
           {"J", rows, static_cast<int>(n), J, "1", "d(positions)/dq"}}};
}

CompiledModel compiled(const Mechanism& mechanism, bool moving_base,
                       const std::filesystem::path& runtime) {
  if (is_massless(mechanism)) throw std::invalid_argument(why_no_dynamics(mechanism));
  if (const auto joint = joint_without_inertia(mechanism))
    throw std::invalid_argument(
        mechanism.name + " cannot be simulated: its joint '" + mechanism.joints[*joint].name +
        "' can move without moving any inertia; give the bodies that it carries some");
  std::vector<Function> functions;
  if (moving_base) {
    functions = tendon_functions(mechanism);
    if (!mechanism.tendons.empty()) functions.push_back(tendon_bending_angles(mechanism));
    functions.push_back(moving_base_forward_dynamics(mechanism));
    functions.push_back(moving_base_inverse_dynamics(mechanism));
    functions.push_back(moving_base_mass_matrix(mechanism));
  } else {
    functions = functions_of(mechanism, emitted_cost);
  }
  functions.push_back(moving_joints(mechanism));
  return CompiledModel(assemble({mechanism.name, mechanism.description, "", {}}, functions, {}),
                       runtime);
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

FingerDynamics::FingerDynamics(const Mechanism& mechanism, bool moving_base,
                               const std::filesystem::path& runtime)
    : model_(compiled(mechanism, moving_base, runtime)),
      bodies_(mechanism),
      n_(static_cast<std::size_t>(Coordinates(mechanism).count())),
      m_(mechanism.tendons.size()),
      moving_base_(moving_base),
      damping_(damping_of(mechanism, model_)) {
  find_functions(moving_base);
  for (const sinew_function* function : {acceleration_, inverse_, mass_matrix_, joints_})
    if (function->input_size > static_cast<int>(kMostNumbers) ||
        function->output_size > static_cast<int>(kMostNumbers))
      throw std::runtime_error(mechanism.name + ": too many joints to simulate");
  if (n_ + 2 * m_ > kMostNumbers)
    throw std::runtime_error(mechanism.name + ": too many tendons to simulate");
}

void FingerDynamics::find_functions(bool moving_base) {
  const std::string prefix = moving_base ? "moving_base_" : "";
  joints_ = &model_.find("moving_joints");
  acceleration_ = &model_.find(prefix + "forward_dynamics");
  inverse_ = &model_.find(prefix + "inverse_dynamics");
  mass_matrix_ = &model_.find(prefix + "mass_matrix");
  if (m_ == 0) return;
  lengths_ = &model_.find("tendon_lengths");
  coupling_ = &model_.find("coupling_matrix");
  torque_ = &model_.find("joint_torque");
  stiffness_ = &model_.find("joint_stiffness");
  bending_ = &model_.find("bending_angles");
}

void FingerDynamics::acceleration(const double* q, const double* qd, const double* tau,
                                  const double* base, double* qdd) const {
  double in[kMostNumbers];
  double* next = std::copy(q, q + n_, in);
  next = std::copy(qd, qd + n_, next);
  next = std::copy(tau, tau + n_, next);
  if (moving_base_) std::copy(base, base + 9, next);
  acceleration_->call(in, qdd);
}

void FingerDynamics::inverse(const double* q, const double* qd, const double* qdd,
                             const double* base, double* tau, double* wrench) const {
  double in[kMostNumbers], out[kMostNumbers];
  double* next = std::copy(q, q + n_, in);
  next = std::copy(qd, qd + n_, next);
  next = std::copy(qdd, qdd + n_, next);
  if (moving_base_) std::copy(base, base + 9, next);
  inverse_->call(in, out);
  std::copy(out, out + n_, tau);
  if (moving_base_) std::copy(out + n_, out + n_ + 6, wrench);
}

double FingerDynamics::energy(const double* q, const double* qd, const MovingFrame& base,
                              const Eigen::Vector3d& gravity) const {
  double joints[kMostNumbers], rates[kMostNumbers];  // positions, then J
  joints_->call(q, joints);
  const std::size_t moving = static_cast<std::size_t>(joints_->output_size) / (n_ + 1);
  const double* J = joints + moving;
  for (std::size_t i = 0; i < moving; ++i) {
    rates[i] = 0.0;
    for (std::size_t k = 0; k < n_; ++k) rates[i] += *J++ * qd[k];
  }
  return bodies_.at(joints, rates, base, gravity);
}

void FingerDynamics::torque(const double* q, const double* f, double* tau) const {
  double in[kMostNumbers];
  std::copy(f, f + m_, std::copy(q, q + n_, in));
  torque_->call(in, tau);
}

void FingerDynamics::stiffness(const double* q, const double* f, const double* kt,
                               double* K) const {
  double in[kMostNumbers];
  std::copy(kt, kt + m_, std::copy(f, f + m_, std::copy(q, q + n_, in)));
  stiffness_->call(in, K);
}

}  // namespace sinew
