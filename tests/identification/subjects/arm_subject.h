// SPDX-License-Identifier: GPL-3.0-or-later
// The arm of five joints under diagnosis, its log read and prepared, no search.
#pragma once

#include <numbers>

#include "identification/logs/carried_payload.h"
#include "identification/subjects/driven_subject.h"
#include "tests/identification/subjects/arm_logs.h"

namespace sinew::test {

/// `nominal`: the model under diagnosis. `carried`: with which load of known mass the log was
/// recorded; nullptr: none.
diagnosis::DrivenSubject prepared_arm(const Mechanism& nominal, const ArmLog& logged,
                                      const diagnosis::Settings& settings = {},
                                      const CarriedPayload* carried = nullptr);

/// As encoders with these steps [rad] read it, of 18 bits where nothing is said.
ArmLog with_encoder_steps(ArmLog log, double step = 2.0 * std::numbers::pi / (1 << 18));

}  // namespace sinew::test
