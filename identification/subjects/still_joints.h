// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that no log moves: they are held in the model, and nothing is said of them.
#pragma once

#include "symbolic/model/held_joints.h"

namespace sinew::diagnosis {

/// The joints of the mechanism whose position is the same, noise and a sensor's steps aside, in
/// all of the files, where it is logged. `map`: texts of --map. Throws as read_csv does.
std::vector<HeldJoint> still_joints(const Mechanism& mechanism,
                                    const std::vector<std::string>& files,
                                    const std::vector<std::string>& map);

/// "joint 'elbow' does not move in these logs: it is held at 0.3 rad, and nothing is said of it".
std::string said_of(const HeldJoint& held, const Mechanism& mechanism);

}  // namespace sinew::diagnosis
