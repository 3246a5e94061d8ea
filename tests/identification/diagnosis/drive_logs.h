// SPDX-License-Identifier: GPL-3.0-or-later
// The two measured logs, read crudely. Empty where the data folder is absent.
#pragma once

#include <optional>

#include "identification/regression/candidate.h"

namespace sinew::test {

using namespace diagnosis;

/// Positioning drive: q, derivatives and motor force at 1 kHz.
std::optional<Recording> read_positioning_drive();

/// Master-arm joint with a cable: q, derivatives and torque at 200 Hz.
std::optional<Recording> read_cable_joint();

}  // namespace sinew::test
