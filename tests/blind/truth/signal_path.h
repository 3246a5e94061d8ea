// SPDX-License-Identifier: GPL-3.0-or-later
// Between the mechanics and the log: the amplifier and its motor, and the position sensor.
#pragma once

#include "tests/blind/truth/hidden.h"

namespace sinew::trials {

/// What the log says of an effort that has been needed. `peak`: the largest usual effort.
VectorXd logged_effort(const VectorXd& needed, const std::vector<Hidden>& hidden, double step,
                       double peak);
bool acts_on_amplifier(const std::string& cause);

/// What the sensor says of a position.
VectorXd sensed_position(const VectorXd& q, const std::vector<Hidden>& hidden, double step);
bool acts_on_sensor(const std::string& cause);

/// Those of the causes that are at this place.
std::vector<Hidden> only_at(const std::vector<Hidden>& hidden, int at);

}  // namespace sinew::trials
