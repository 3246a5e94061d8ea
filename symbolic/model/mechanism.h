// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism as plain data: what a model folder or a URDF says, checked, in SI units.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "symbolic/files/source_location.h"

namespace sinew {

/// Maps child coordinates to parent coordinates: x_parent = rotation * x_child + translation [m].
struct Transform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

enum class JointType { revolute, prismatic, fixed };

/// A rigid body; its frame is the frame of the joint that carries it (after the joint's motion).
struct Body {
  std::string name;
  std::string source_name;  ///< in the file that it was imported from; "" where that is the same
  double mass = 0.0;        ///< kg
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();  ///< m, body frame
  Eigen::Matrix3d inertia =
      Eigen::Matrix3d::Zero();  ///< kg m^2, about the centre of mass, body axes
  SourceLocation where;
};

/// Joint i carries body i: T_parent_child(q) = origin * motion(axis, q).
struct Joint {
  std::string name;
  std::string source_name;  ///< in the file that it was imported from; "" where that is the same
  JointType type = JointType::revolute;
  int parent = -1;  ///< body index; -1 is the base
  Transform origin;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit, in the joint frame
  double low = -3.141592653589793;                  ///< rad or m
  double high = 3.141592653589793;
  std::optional<double> reference;  ///< rad or m, of the reference pose; none: mid-range
  double max_velocity = 10.0;       ///< rad/s or m/s: sampling range of tests
  double max_acceleration = 100.0;  ///< rad/s^2 or m/s^2: sampling range of tests
  double damping = 0.0;             ///< N m s/rad or N s/m, viscous; simulation only
  // The joint's drive, for simulation and for comparing with measurements.
  double friction = 0.0;        ///< N m or N: what remains of friction at high speed, damping aside
  double friction_speed = 0.0;  ///< rad/s or m/s: friction * 2/pi atan(velocity / it); 0: unknown
  double armature = 0.0;        ///< kg m^2 or kg: the motor's inertia seen at the joint
  double motor_turn = 0.0;  ///< rad or m: motion of the joint for one turn of its motor; 0: unknown
  int motor_poles = 0;      ///< of its motor's magnets, twice the pole pairs; 0: unknown
  int motor_slots = 0;      ///< of its motor's stator; 0: unknown
  int gear_teeth = 0;       ///< of the gear on its motor's shaft; 0: unknown
  SourceLocation where;
};

/// Constant moment arm: dh/dq = radius (signed) at one joint (5.5).
struct PulleyRouting {
  std::string joint;
  double radius = 0.0;  ///< m, signed
};

/// Straight stretch of tendon between points of two bodies; contributes |p_to - p_from| (5.20).
struct StraightRouting {
  std::string from_body;                           ///< "base" for the base frame
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< m
  std::string to_body;
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
};

/// A tendon's path: h(q) = h0 + sum of its pulleys' radius*q + sum of its straight stretches.
struct Tendon {
  std::string name;
  double h0 = 0.0;  ///< m
  std::vector<PulleyRouting> pulleys;
  std::vector<StraightRouting> straights;
  SourceLocation where;
};

/// q_dependent = ratio * q_independent + offset, for instance a tendon loop between PIP and DIP
/// (5.16), or a joint that mimics another one.
struct JointCoupling {
  std::string dependent;
  std::string independent;
  double ratio = 1.0;
  double offset = 0.0;  ///< rad or m, as the dependent joint moves
  SourceLocation where;
};

/// A joint that a planar four-bar linkage moves with another one (5.5). The linkage's crank turns
/// with the independent joint, its angle crank_angle at coordinate zero; the dependent joint turns
/// with the rocker (against the ground) or with the coupler (against the crank), zero at the
/// independent joint's zero.
struct FourBarCoupling {
  enum class Follows { rocker, coupler };
  std::string dependent;
  std::string independent;
  double ground = 0.0, crank = 0.0, coupler = 0.0, rocker = 0.0;  ///< m, between the pivots
  int branch = -1;           ///< -1 open, +1 crossed, for a crank turned to positive angles
  double crank_angle = 0.0;  ///< rad
  Follows follows = Follows::rocker;
  SourceLocation where;
};

/// A frame fixed to a body whose pose is offered, for instance the fingertip.
struct Frame {
  std::string name;
  std::string body;
  Transform pose;  ///< frame to body
  SourceLocation where;
};

/// Bodies and joints in depth-first order: joints[i].parent < i, and joint i moves body i.
/// Fixed joints are allowed; the moving ones are the generalised coordinates, in this order.
struct Mechanism {
  std::string name;  ///< C identifier, prefix of emitted functions
  std::string description;
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};  ///< m/s^2, base frame
  std::vector<Body> bodies;
  std::vector<Joint> joints;  ///< same size as bodies
  std::vector<Tendon> tendons;
  std::vector<JointCoupling> couplings;
  std::vector<FourBarCoupling> four_bars;
  std::vector<Frame> frames;            ///< the first is "the tip"
  double tendon_stiffness_low = 1.0e3;  ///< N/m: sampling range of tests
  double tendon_stiffness_high = 5.0e4;
  double tendon_force_high = 100.0;               ///< N: sampling range of tests
  std::map<std::string, std::string> provenance;  ///< value path -> "text ..." or "assumed ..."
};

/// Generalised coordinate of each joint: 0.. for moving joints, -1 for fixed ones.
std::vector<int> coordinate_of_joint(const Mechanism& mechanism);

/// Number of moving joints.
int coordinate_count(const Mechanism& mechanism);

/// Whether no body has mass: a description of kinematics alone, as a robot of links without
/// <inertial> is. Nothing that needs a mass can be said of it.
bool is_massless(const Mechanism& mechanism);

/// Why dynamics are refused for such a mechanism, and what to add.
std::string why_no_dynamics(const Mechanism& mechanism);

}  // namespace sinew
