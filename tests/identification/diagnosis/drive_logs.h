// SPDX-License-Identifier: GPL-3.0-or-later
// A measured log, read crudely. Empty where the data folder is absent.
#pragma once

#include <optional>

#include "identification/regression/candidate.h"

namespace sinew::test {

using namespace diagnosis;

/// Master-arm joint with a cable: q, derivatives and torque at 200 Hz.
std::optional<Recording> read_cable_joint();

}  // namespace sinew::test
