// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/held_joints.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

namespace sinew {
namespace {

void hold(Mechanism& mechanism, const HeldJoint& held) {
  for (const FourBarCoupling& bars : mechanism.four_bars)
    if (bars.independent == held.name || bars.dependent == held.name)
      throw std::invalid_argument("joint '" + held.name + "' of '" + mechanism.name +
                                  "' does not move, and drives a four-bar that then would not; "
                                  "take logs in which it moves");
  for (const JointCoupling& coupling : mechanism.couplings)
    if (coupling.independent == held.name)
      for (Joint& joint : mechanism.joints)
        if (joint.name == coupling.dependent)
          fix_at(joint, coupling.ratio * held.position + coupling.offset);
  std::erase_if(mechanism.couplings,
                [&](const JointCoupling& c) { return c.independent == held.name; });
  for (Joint& joint : mechanism.joints)
    if (joint.name == held.name) fix_at(joint, held.position);
  // What a pulley takes up at a joint that rests does not change.
  for (Tendon& tendon : mechanism.tendons)
    std::erase_if(tendon.pulleys,
                  [&](const PulleyRouting& pulley) { return pulley.joint == held.name; });
}

}  // namespace

void fix_at(Joint& joint, double position) {
  if (joint.type == JointType::revolute)
    joint.origin.rotation =
        joint.origin.rotation * Eigen::AngleAxisd(position, joint.axis).toRotationMatrix();
  else
    joint.origin.translation += joint.origin.rotation * joint.axis * position;
  joint.type = JointType::fixed;
}

Mechanism with_held(Mechanism mechanism, const std::vector<HeldJoint>& held) {
  if (held.empty()) return mechanism;
  for (const HeldJoint& each : held) hold(mechanism, each);
  if (coordinate_count(mechanism) == 0)
    throw std::invalid_argument("no joint of '" + mechanism.name + "' moves");
  return mechanism;
}

}  // namespace sinew
