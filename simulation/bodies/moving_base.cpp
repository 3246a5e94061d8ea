// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/bodies/moving_base.h"

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/forward_dynamics.h"
#include "symbolic/dynamics/mass_matrix.h"
#include "symbolic/dynamics/recursive_lagrangian.h"
#include "symbolic/dynamics/symbols.h"

namespace sinew {
namespace {

using GiNaC::ex;

constexpr std::size_t base_joints = 6;

std::vector<ex> symbols_of(const Argument& argument) {
  return {argument.symbols.begin(), argument.symbols.end()};
}

/// Three joints that slide along x, y, z and three that turn about them, without mass; at their
/// zero the last one's frame is the base frame.
Mechanism behind_base_joints(const Mechanism& mechanism) {
  Mechanism whole;
  whole.name = mechanism.name;
  whole.gravity.setZero();
  for (int i = 0; i < static_cast<int>(base_joints); ++i) {
    Joint joint;
    joint.name = "moving_base_" + std::to_string(i);
    joint.type = i < 3 ? JointType::prismatic : JointType::revolute;
    joint.parent = i - 1;
    joint.axis = Eigen::Vector3d::Unit(i % 3);
    Body body;
    body.name = joint.name;
    whole.joints.push_back(joint);
    whole.bodies.push_back(body);
  }
  for (Joint joint : mechanism.joints) {
    joint.parent += static_cast<int>(base_joints);
    whole.joints.push_back(joint);
  }
  whole.bodies.insert(whole.bodies.end(), mechanism.bodies.begin(), mechanism.bodies.end());
  whole.couplings = mechanism.couplings;
  whole.four_bars = mechanism.four_bars;
  return whole;
}

class MovingBase {
 public:
  explicit MovingBase(const Mechanism& mechanism)
      : mechanism_(mechanism),
        q_(joint_positions(mechanism)),
        qd_(joint_velocities(mechanism)),
        base_(make_argument("base", 9, 1, "SI",
                            "angular velocity, angular acceleration, "
                            "acceleration less gravity, base frame",
                            {-10.0, 10.0})) {}

  Function inverse_dynamics_function() {
    const Argument qdd = joint_accelerations(mechanism_);
    const std::vector<ex> forces = generalised_forces(symbols_of(qdd));
    const auto joints = forces.begin() + static_cast<std::ptrdiff_t>(base_joints);
    return {"moving_base_inverse_dynamics",
            "Joint torques of a motion on a moving base, and the base's wrench.",
            "(2.1)",
            {q_, qd_, qdd, base_},
            list_.items(),
            {{"tau", q_.rows, 1, {joints, forces.end()}, torque_unit(mechanism_), "joint torques"},
             {"wrench", 6, 1, {forces.begin(), joints}, "N, N m", "on the mechanism, base frame"}}};
  }

  Function forward_dynamics_function() {
    const Argument tau = joint_torques(mechanism_);
    const std::vector<ex> M = reduced_mass_matrix();
    const std::vector<ex> forces = generalised_forces(std::vector<ex>(symbols_of(q_).size(), 0));
    std::vector<ex> rest;
    for (std::size_t i = 0; i < tau.symbols.size(); ++i)
      rest.push_back(list_.define("rest", tau.symbols[i] - forces[base_joints + i]));
    const std::vector<ex> qdd = solve_mass_matrix(list_, M, rest);
    return {
        "moving_base_forward_dynamics",
        "Joint accelerations on a moving base.",
        "(2.1)",
        {q_, qd_, tau, base_},
        list_.items(),
        {{"qdd", q_.rows, 1, qdd, joint_accelerations(mechanism_).unit, "joint accelerations"}}};
  }

  Function mass_matrix_function() {
    const std::vector<ex> M = reduced_mass_matrix();
    return {"moving_base_mass_matrix",
            "Mass matrix M(q) of the joints alone.",
            "(2.1)",
            {q_},
            list_.items(),
            {{"M", q_.rows, q_.rows, M, "SI", "symmetric"}}};
  }

 private:
  /// Of the base's joints, then of the coordinates.
  std::vector<ex> generalised_forces(const std::vector<ex>& qdd) {
    const Mechanism whole = behind_base_joints(mechanism_);
    const auto b = symbols_of(base_);
    // The base turns about x, then y, then z of the frames before: at their zero their rates are
    // the angular velocity, and the axes that turn with the joints before bring these products.
    std::vector<ex> positions(base_joints, 0), rates{0, 0, 0, b[0], b[1], b[2]},
        accelerations{b[6],
                      b[7],
                      b[8],
                      list_.define("turn_x", b[3] - b[1] * b[2]),
                      list_.define("turn_y", b[4] + b[0] * b[2]),
                      list_.define("turn_z", b[5] - b[0] * b[1])};
    append(positions, symbols_of(q_));
    append(rates, symbols_of(qd_));
    append(accelerations, qdd);
    const JointMap joints = Coordinates(whole).at(list_, positions);
    const JointState state{joints.positions(), joints.velocities(rates),
                           joints.accelerations(list_, rates, accelerations)};
    return joints.projected(inverse_dynamics(list_, build_joint_tree(whole), {}, state));
  }

  std::vector<ex> reduced_mass_matrix() {
    const JointMap joints = Coordinates(mechanism_).at(list_, symbols_of(q_));
    return joints.projected_matrix(
        mass_matrix(list_, build_joint_tree(mechanism_), {}, joints.positions()));
  }

  static void append(std::vector<ex>& to, const std::vector<ex>& more) {
    to.insert(to.end(), more.begin(), more.end());
  }

  const Mechanism& mechanism_;
  Argument q_, qd_, base_;
  DefinitionList list_;
};

}  // namespace

Function moving_base_inverse_dynamics(const Mechanism& mechanism) {
  return MovingBase(mechanism).inverse_dynamics_function();
}

Function moving_base_forward_dynamics(const Mechanism& mechanism) {
  return MovingBase(mechanism).forward_dynamics_function();
}

Function moving_base_mass_matrix(const Mechanism& mechanism) {
  return MovingBase(mechanism).mass_matrix_function();
}

}  // namespace sinew
