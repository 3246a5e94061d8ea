// SPDX-License-Identifier: GPL-3.0-or-later
// A sealed trial on a lone joint whose controller follows a motion: friction is met in closed loop,
// with reversals shorter than a sample of the log.
#pragma once

#include "tests/blind/robot_trial.h"

namespace sinew::blind {

/// A pendulum, a flywheel or a slide. request.family: nothing or one; request.size: in hundredths
/// of the effort's rms, about, where the noise is one hundredth.
RobotTrial joint_trial(const truth::TrialRequest& request);

}  // namespace sinew::blind
