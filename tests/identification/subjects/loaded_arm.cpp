// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/subjects/loaded_arm.h"

namespace sinew::test {

Mechanism loaded(Mechanism arm, double load) {
  Body& hand = arm.bodies.back();
  const double mass = hand.mass + load;
  const Eigen::Vector3d centre = (hand.mass * hand.centre_of_mass + load * kLoadCentre) / mass;
  const auto about = [&](double m, const Eigen::Vector3d& from) {
    const Eigen::Vector3d d = from - centre;
    return Eigen::Matrix3d(m * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose()));
  };
  hand.inertia += about(hand.mass, hand.centre_of_mass) + about(load, kLoadCentre);
  hand.mass = mass;
  hand.centre_of_mass = centre;
  return arm;
}

}  // namespace sinew::test
