// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "symbolic/model/mechanism.h"
#include "tests/blind/truth/sealed_trial.h"

namespace sinew::blind {

/// A robot with its efforts logged at the joints.
struct RobotTrial {
  Mechanism nominal;           ///< what the program gets, with the logs
  std::string train, holdout;  ///< CSV text: time, q_<joint>, tau_<joint>
  truth::Seal seal;
};

}  // namespace sinew::blind
