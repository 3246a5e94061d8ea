// SPDX-License-Identifier: GPL-3.0-or-later
// The wrist: a double inverted parallelogram carrying 38 tendons (chapter 6).
//
// Forearm frame {0}: origin B0, y from B0 to C0, x distal, z = x × y. Two bar angles move it: q71
// turns the bar plane about y, q73 swings the bar B0-B within that plane. Both are absolute: the
// reference pose (palm parallel to the forearm) is q71 = atan2(c, a), q73 = acos(b/r).
//
// Branches: B0-B-C-C0 is the crossed loop (antiparallelogram), and so is A0-A-M. They meet their
// uncrossed twins in the singular poses: flat (sin q73 = 0) and dead centre (A0, A and M in one
// plane with BC), where the derivatives of the palm's pose have no bound.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "generator/function.h"

namespace sinew {

struct WristParameters {
  double length = 0.0;                          ///< a [m], Table 6.1
  double width = 0.0;                           ///< b [m]
  double thickness = 0.0;                       ///< c [m]
  std::vector<Eigen::Vector3d> forearm_points;  ///< {0} [m], one per tendon, Table 6.2
  std::vector<Eigen::Vector3d> palm_points;     ///< {ABC} [m], one per tendon
  double motor_radius = 0.0;                    ///< R_motor [m]
  Range flexion{0.0, 0.0};                      ///< palm [rad]: the range of use
  Range abduction{0.0, 0.0};                    ///< palm [rad]
  double singular_margin = 1e-6;  ///< rad; nearer than this counts as being in a singular pose
  int newton_iterations = 4;      ///< of the map from palm to bar angles
};

/// Bar angles of the reference pose [rad].
double reference_q71(const WristParameters& parameters);
double reference_q73(const WristParameters& parameters);

/// Both, rounded to a microradian: the same digits on every machine.
std::vector<double> rounded_reference(const WristParameters& parameters);

/// Smallest intervals of q71 and q73 [rad] that cover the palm's range of use, rounded outwards to
/// a milliradian.
std::vector<Range> bar_ranges(const WristParameters& parameters);

// Every function is defined and finite for any finite input; in a singular pose it continues
// smoothly from the margin and wrist_status tells. Names are without the prefix "wrist_".

/// pose(q71, q73 -> T 4x4): maps {ABC} to {0}.
Function wrist_pose(const WristParameters& parameters);
/// points(q71, q73 -> ABC 3x3): rows A, B, C in {0} [m].
Function wrist_points(const WristParameters& parameters);
/// palm_angles(q71, q73 -> angles 2): flexion, abduction [rad].
Function wrist_palm_angles(const WristParameters& parameters);
/// bar_angles(flexion, abduction -> q 2, residual 1, status 1): q71, q73 [rad]; residual: angle
/// between the wanted and the reached direction of the palm [rad]; status 1 beyond the workspace.
/// Closed form but for q71, which takes a fixed number of Newton steps from its value at zero
/// abduction (which is closed form).
Function wrist_bar_angles(const WristParameters& parameters);
/// singularity(q71, q73 -> distance 2): angles [rad] to the flat pose and to the dead centre.
Function wrist_singularity(const WristParameters& parameters);
/// status(q71, q73 -> status 1): 0 fine, 1 at or beyond a singular pose.
Function wrist_status(const WristParameters& parameters);

/// tendon_lengths(q71, q73 -> h m): h_i = |F_i - T P_i| [m] (6.9).
Function wrist_tendon_lengths(const WristParameters& parameters);
/// tendon_jacobian(q71, q73 -> P m x 2) [m/rad].
Function wrist_tendon_jacobian(const WristParameters& parameters);
/// tendon_hessian(q71, q73 -> H m x 4): each row a symmetric 2x2 matrix [m/rad²].
Function wrist_tendon_hessian(const WristParameters& parameters);
/// bending_angles(q71, q73 -> angles m): how far each tendon is bent in all, at its forearm and its
/// palm point, against the x axes of {0} and {ABC} [rad]; for the guiding friction.
Function wrist_bending_angles(const WristParameters& parameters);
/// feedforward(q71, q73 -> delta_theta m): motor angles [rad] that take up what the wrist changes
/// since the reference pose, -(h_i - h_i,0)/R_motor.
Function wrist_feedforward(const WristParameters& parameters);
/// feedforward_rate(q71, q73, dq71, dq73 -> delta_theta_rate m) [rad/s].
Function wrist_feedforward_rate(const WristParameters& parameters);
/// joint_torque(q71, q73, f m -> tau 2): -Pᵀ f on q71, q73 [N·m].
Function wrist_joint_torque(const WristParameters& parameters);
/// joint_stiffness(q71, q73, f m, k m -> K 2x2): Σ f ∂²h/∂q² + Pᵀ diag(k) P [N·m/rad].
Function wrist_joint_stiffness(const WristParameters& parameters);
/// passage_stiffness(q71, q73, h m, P m x 2, f m, k m -> K 2x2): the same from lengths and Jacobian
/// that are known.
Function wrist_passage_stiffness(const WristParameters& parameters);
/// finger_stiffness(q71, q73, k, P_finger -> K 2 x joints): P_wristᵀ diag(k) P_finger over the
/// given tendons [N·m/rad], the off-diagonal block of the stiffness of wrist and finger together.
/// `name` is the function's name; `channels` are the finger's tendons, from 0; P_finger has one row
/// each.
Function wrist_finger_stiffness(const WristParameters& parameters, const std::string& name,
                                const std::vector<int>& channels, int joints);

/// All of the above but finger_stiffness and passage_stiffness.
std::vector<Function> wrist_functions(const WristParameters& parameters);

}  // namespace sinew
