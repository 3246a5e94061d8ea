// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism in the frames that make its equations short. Nothing here changes its motion.
#pragma once

#include <string>
#include <vector>

#include "symbolic/dynamics/composite_inertia.h"
#include "symbolic/model/mechanism.h"
#include "symbolic/expressions/number.h"

namespace sinew {

/// Where along its axis a joint's frame sits.
enum class OriginChoice {
  incoming,  ///< foot of the common normal from the parent's axis
  outgoing   ///< foot of the common normal to the child's axis
};

/// How the frame of a link without children is turned about its axis.
enum class LeafTurn {
  none,
  no_first_moment_y,     ///< the centre of mass lies in the xz plane: J(y,1) = 0
  no_product_of_inertia  ///< J(x,y) = 0
};

/// Free choices of frames of one joint.
struct FrameChoice {
  OriginChoice origin = OriginChoice::incoming;
  LeafTurn leaf = LeafTurn::none;
};

/// A moving joint and the link it carries, in canonical frames: the axis is z; the frame's x runs
/// along the common normal to the first child's axis where there is one.
///
/// T_parent_link = [R p; 0 1] * Rz(phi) with phi = sign*q + quarter_turns*pi/2 + remainder
/// (revolute), or * Tz(sign*q) (prismatic). R is a rotation about x wherever the geometry allows.
struct TreeLink {
  std::string name;
  JointType type = JointType::revolute;
  int coordinate = 0;  ///< index into q
  int parent = -1;     ///< tree link; -1 is the base
  NumberMatrix3 R;
  NumberVector3 p;
  int sign = 1;
  int quarter_turns = 0;            ///< 0..3
  Number remainder = 0;             ///< rad
  bool parallel_to_parent = false;  ///< revolute, and so is the parent, with equal axes
  std::vector<int> children;
  /// Pseudo-inertia about the link's origin, base parameters folded in:
  /// [integral r r^T dm, integral r dm; ., m].
  NumberMatrix4 J;
};

/// Where a body of the mechanism has gone.
struct BodyPlace {
  int link = -1;    ///< tree link that carries it; -1 is the base
  NumberMatrix3 R;  ///< body axes in the link's frame
  NumberVector3 p;  ///< body origin in the link's frame, m
};

struct JointTree {
  std::vector<BodyPlace> bodies;  ///< in the mechanism's order
  std::vector<TreeLink> links;    ///< parents before children; fixed joints merged
  NumberVector3 gravity;          ///< base frame
  /// What the equations are written with: the numbers above, or symbols (runtime_parameters.h).
  std::vector<PseudoInertia> inertias;  ///< one a link
  Vector3ex gravity_vector;
};

/// Canonical tree for the choices given (one a moving joint; missing ones take the default).
JointTree build_joint_tree(const Mechanism& mechanism,
                           const std::vector<FrameChoice>& choices = {});

/// Pseudo-inertia of a body about its frame's origin.
NumberMatrix4 pseudo_inertia(const Body& body);

}  // namespace sinew
