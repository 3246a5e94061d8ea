// SPDX-License-Identifier: GPL-3.0-or-later
// A sealed trial on a robot arm with its torques logged at the joints. The truth is Newton-Euler
// numerics (tests/reference) with a friction that turns or rests as drawn; the motion runs on or
// rests between strokes; encoders have steps as encoders have.
#pragma once

#include "tests/blind/robot_trial.h"

namespace sinew::blind {

/// request.plant: "arm" of two or three joints, or "long_arm" of five or six, its last link a
/// hundredth to a sixth of the first; all of a long arm's torques may be measured late.
/// request.family: nothing or one; request.size: rms of what is hidden over that of the noise.
RobotTrial arm_trial(const truth::TrialRequest& request);

}  // namespace sinew::blind
