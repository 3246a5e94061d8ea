// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments of emitted functions and the symbols behind them; nothing else creates input symbols.
#pragma once

#include <string>
#include <vector>

#include "generator/function.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// `rows * cols` symbols <name>0, <name>1, ... with one range for all.
Argument make_argument(const std::string& name, int rows, int cols, const std::string& unit,
                       const std::string& doc, Range range);

/// q, rad (revolute) or m (prismatic), in coordinate order, ranges from the joints' limits.
Argument joint_positions(const Mechanism& mechanism);
/// qd, rad/s or m/s.
Argument joint_velocities(const Mechanism& mechanism);
/// qdd, rad/s^2 or m/s^2.
Argument joint_accelerations(const Mechanism& mechanism);
/// tau, N m or N.
Argument joint_torques(const Mechanism& mechanism);

/// "rad", "m" or "rad | m" by the joints' types, with `suffix` behind each.
std::string coordinate_unit(const Mechanism& mechanism, const std::string& suffix);
/// "N m", "N" or "N m | N".
std::string torque_unit(const Mechanism& mechanism);

}  // namespace sinew
