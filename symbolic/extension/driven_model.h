// SPDX-License-Identifier: GPL-3.0-or-later
// Joints with their drives, as a measured log sees them: position in, effort out. The model that a
// diagnosis compares with measurements and extends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/function.h"
#include "symbolic/dynamics/choose_plan.h"
#include "symbolic/extension/identified.h"
#include "symbolic/model/mechanism.h"
#include "symbolic/parts/motor.h"

namespace sinew {

/// A coordinate and what drives it.
struct DrivenJoint {
  std::string name;    ///< of the joint; "motor" for a motor, "motor 3" for a tendon's
  bool motor = false;  ///< a motor's shaft, no joint
  bool revolute = true;
  bool carries_links =
      false;  ///< load of its effects: what the links ask of it, and an external one
  Range position, velocity, acceleration;  ///< SI
  double damping = 0.0;                    ///< N m s/rad or N s/m
  double friction = 0.0;                   ///< N m or N: level at high speed
  double friction_speed = 0.0;             ///< rad/s or m/s; 0: unknown
  double armature = 0.0;                   ///< kg m^2 or kg
  double motor_turn = 0.0;                 ///< motion for one turn of the motor; 0: unknown
  double output_turn = 0.0;                ///< motion for one turn of the output; 0: does not turn
  std::vector<int> motor_orders;   ///< periods in a turn of the motor that its parts are known for
  std::vector<int> output_orders;  ///< in a turn of the output
};

/// The tendons that drive the first coordinates: there the effort is -P^T f of their measured
/// forces.
struct DrivenTendons {
  std::vector<std::string> names;
  Function motion;           ///< tendon_motion of the coordinates that they drive
  double slip_speed = 1e-4;  ///< m/s over which their friction turns
  std::optional<MotorParameters>
      motor;  ///< of each tendon; their coordinates come behind the joints'
  int coordinates() const { return motion.inputs.empty() ? 0 : motion.inputs.front().rows; }
};

struct DrivenModel {
  std::string name;
  Function rigid;  ///< (q, qd, qdd -> tau), n each: everything but the joints' drives
  std::vector<DrivenJoint> joints;
  DrivenTendons tendons;  ///< none where the efforts are measured at the joints
};

/// Those of a mechanism's coordinates, with what their followers leave to them.
std::vector<DrivenJoint> driven_joints(const Mechanism& mechanism);

/// Efforts measured at the joints.
DrivenModel driven_model(const Mechanism& mechanism, const CostOf& cost = {});
DrivenModel driven_model(const MotorParameters& motor, const std::string& name);
/// Forces measured in the tendons, and with a motor for each of them the motors' efforts. Throws
/// std::invalid_argument for a mechanism without tendons.
DrivenModel tendon_driven_model(const Mechanism& mechanism,
                                const std::optional<MotorParameters>& motor,
                                const CostOf& cost = {});

/// Speed over which friction turns where it is not known: a thousandth of the joint's highest.
double assumed_friction_speed(const DrivenJoint& joint);

/// effort(q, qd, qdd, load, tension, qddd, qdddd, time, step, memory -> tau, next): effort that the
/// drives have to give for a motion against an external load: rigid body, armature, friction, and
/// the identified effects. Arguments that nothing depends on are left out; n numbers each for q,
/// qd, qdd, load and tau, one tension [N] for every tendon, one state for every effect that has
/// one, in their order. Throws std::invalid_argument for an effect at a place that the model has
/// not.
Function effort_function(const DrivenModel& model, const Identified& identified);

/// The same function, named motor_effort, of the tendons' motors: tau is 0 for the joints, whose
/// rigid body is left out.
Function motor_effort_function(const DrivenModel& model, const Identified& identified);

/// compensation(q, qd[, load] -> tau): feedforward of the identified effects that follow from what
/// the firmware measures, `share` of each so that friction is never over-compensated. No outputs
/// where there is none.
Function compensation_function(const DrivenModel& model, const Identified& identified,
                               double share = 0.9);

}  // namespace sinew
