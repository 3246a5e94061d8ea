// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/driven_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/dynamics_functions.h"
#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/tendons/tendon_motion.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// Ripple of a motor's parts: its current's sensors and amplifiers once and twice, its commutation
/// six times a pair of poles, the slots' cogging, the teeth of its gear.
std::vector<int> known_orders(const Joint& joint) {
  std::set<int> orders;
  const int pairs = joint.motor_poles / 2;
  for (const int order : {pairs, 2 * pairs, 6 * pairs, joint.gear_teeth}) orders.insert(order);
  if (pairs > 0 && joint.motor_slots > 0)
    orders.insert(std::lcm(joint.motor_poles, joint.motor_slots));
  orders.erase(0);
  return {orders.begin(), orders.end()};
}

std::vector<int> orders_of(const std::vector<Ripple>& ripples) {
  constexpr double most = 1000.0;  // more than any motor or gear has of anything
  std::vector<int> orders;
  for (const Ripple& ripple : ripples)
    if (ripple.order == std::floor(ripple.order) && ripple.order <= most)
      orders.push_back(static_cast<int>(ripple.order));
  return orders;
}

DrivenJoint driven_joint(const Joint& joint) {
  DrivenJoint driven;
  driven.name = joint.name;
  driven.revolute = joint.type == JointType::revolute;
  driven.position = {joint.low, joint.high};
  driven.velocity = {-joint.max_velocity, joint.max_velocity};
  driven.acceleration = {-joint.max_acceleration, joint.max_acceleration};
  driven.damping = joint.damping;
  driven.friction = joint.friction;
  driven.friction_speed = joint.friction_speed;
  driven.armature = joint.armature;
  driven.motor_turn = joint.motor_turn;
  driven.motor_orders = known_orders(joint);
  driven.output_turn = driven.revolute ? 2.0 * std::numbers::pi : 0.0;
  return driven;
}

/// A joint that follows another one at a fixed ratio leaves its losses and inertia to that one.
void add_followers(const Mechanism& mechanism, DrivenJoint& driven) {
  for (const JointCoupling& coupling : mechanism.couplings) {
    if (coupling.independent != driven.name) continue;
    for (const Joint& joint : mechanism.joints) {
      if (joint.name != coupling.dependent) continue;
      driven.damping += coupling.ratio * coupling.ratio * joint.damping;
      driven.armature += coupling.ratio * coupling.ratio * joint.armature;
      driven.friction += std::abs(coupling.ratio) * joint.friction;
    }
  }
}

DrivenJoint driven_motor(const MotorParameters& motor, const std::string& name) {
  DrivenJoint joint;
  joint.name = name;
  joint.motor = true;
  joint.position = motor.theta;
  joint.velocity = motor.velocity;
  joint.acceleration = {-100.0, 100.0};
  joint.damping = motor.gamma3;
  joint.friction = motor.gamma2 * std::numbers::pi / 2.0;
  joint.friction_speed = motor.gamma1 > 0.0 ? 1.0 / motor.gamma1 : 0.0;
  joint.motor_turn = 2.0 * std::numbers::pi * motor.gear_ratio;
  joint.output_turn = 2.0 * std::numbers::pi;
  joint.motor_orders = orders_of(motor.input_ripple);
  joint.output_orders = orders_of(motor.output_ripple);
  return joint;
}

/// As a lone joint's torque does under gravity, and not without.
bool depends_on_position(const Function& rigid) {
  const auto has_position = [&](const ex& value) {
    const auto& q = rigid.inputs.front().symbols;
    return std::any_of(q.begin(), q.end(), [&](const auto& each) { return value.has(each); });
  };
  return std::any_of(rigid.definitions.begin(), rigid.definitions.end(),
                     [&](const Definition& each) { return has_position(each.value); }) ||
         std::any_of(rigid.outputs.front().values.begin(), rigid.outputs.front().values.end(),
                     has_position);
}

}  // namespace

std::vector<DrivenJoint> driven_joints(const Mechanism& mechanism) {
  std::vector<DrivenJoint> joints;
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    joints.push_back(driven_joint(mechanism.joints[static_cast<std::size_t>(index)]));
    add_followers(mechanism, joints.back());
  }
  return joints;
}

DrivenModel driven_model(const Mechanism& mechanism, const CostOf& cost) {
  DrivenModel model;
  model.name = mechanism.name;
  model.rigid = inverse_dynamics_function(mechanism, cost);
  model.joints = driven_joints(mechanism);
  // A lone joint's own inertia is hardly a load to its gear; weight and other links are.
  const bool loaded = model.joints.size() > 1 || depends_on_position(model.rigid);
  for (DrivenJoint& joint : model.joints) joint.carries_links = loaded;
  return model;
}

DrivenModel driven_model(const MotorParameters& motor, const std::string& name) {
  return {name, motor_rigid_torque(motor), {driven_motor(motor, "motor")}, {}};
}

namespace {

/// The finger's rigid torques, then those of one motor for each tendon.
Function with_motors(const Function& rigid, const Function& motor, std::size_t count) {
  std::vector<Argument> inputs;
  for (std::size_t k = 0; k < rigid.inputs.size(); ++k) {
    const Argument& own = rigid.inputs[k];
    inputs.push_back(
        array_argument(own.name, own.rows + static_cast<int>(count), 1, own.unit, {}, own.doc));
    inputs[k].ranges = own.ranges;
    inputs[k].ranges.resize(inputs[k].symbols.size(), motor.inputs[k].ranges.front());
  }
  const auto n = static_cast<std::size_t>(rigid.inputs.front().rows);
  const auto part = [&](std::size_t first, std::size_t size) {
    std::vector<ex> list;
    for (const Argument& argument : inputs)
      list.insert(list.end(), argument.symbols.begin() + static_cast<std::ptrdiff_t>(first),
                  argument.symbols.begin() + static_cast<std::ptrdiff_t>(first + size));
    return list;
  };
  DefinitionList list;
  std::vector<ex> tau = inlined(list, rigid, part(0, n)).front();
  for (std::size_t i = 0; i < count; ++i)
    tau.push_back(inlined(list, motor, part(n + i, 1)).front().front());
  return {"rigid_torque", "Torques that the links and the motors' inertia take, friction aside.",
          "(3.5)",        inputs,
          list.items(),   {{"tau", static_cast<int>(tau.size()), 1, tau, "N m", ""}}};
}

}  // namespace

DrivenModel tendon_driven_model(const Mechanism& mechanism,
                                const std::optional<MotorParameters>& motor, const CostOf& cost) {
  if (mechanism.tendons.empty())
    throw std::invalid_argument("model '" + mechanism.name + "' has no tendons");
  DrivenModel model = driven_model(mechanism, cost);
  model.tendons.motion = tendon_motion_function(mechanism);
  for (DrivenJoint& joint : model.joints) joint.carries_links = false;  // no gear is there
  for (const Tendon& tendon : mechanism.tendons) model.tendons.names.push_back(tendon.name);
  if (!motor) return model;
  model.tendons.motor = motor;
  const std::size_t count = mechanism.tendons.size();
  model.rigid = with_motors(model.rigid, motor_rigid_torque(*motor), count);
  for (std::size_t i = 1; i <= count; ++i)
    model.joints.push_back(driven_motor(*motor, fmt::format("motor {}", i)));
  return model;
}

double assumed_friction_speed(const DrivenJoint& joint) {
  return 1e-3 * std::max(std::abs(joint.velocity.low), std::abs(joint.velocity.high));
}

}  // namespace sinew
