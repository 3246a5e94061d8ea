// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates that act on the model as a whole: their columns come from the emitted effort, moved,
// scaled or differentiated.
#pragma once

#include "identification/subjects/effect_candidate.h"
#include "identification/subjects/effort_model.h"

namespace sinew::diagnosis {

/// The logged effort acts later than logged; or, negative, was measured later than the motion.
Candidate delay_candidate(const EffectPlace& place);

/// One delay of all efforts against all positions, as of a bus or a log that joins two clocks.
Candidate common_delay_candidate();

/// The effort is larger or smaller than logged, by a constant share. Uses signal "effort".
Candidate torque_constant_candidate(const EffectPlace& place);

/// What the efforts of the other joints do with a constant error of one axis' position (per rad or
/// m), with one in proportion to it, with one in proportion to its rate (per second), and with one
/// of its acceleration alone (the column of the mass matrix): signals of samples x joints.
std::string offset_response(int axis);
std::string scale_response(int axis);
std::string rate_response(int axis);
std::string mass_matrix_column(int axis);
/// The first two for a change that is not small, per its size.
std::string far_offset_response(int axis);
std::string far_scale_response(int axis);
/// The mass matrix' column of an axis, samples x joints.
Eigen::MatrixXd mass_column(const EffortModel& effort, int axis, const Recording& log);
void add_sensor_responses(const EffortModel& effort, int axis, Recording& log);

/// The position is logged behind a first-order low-pass. Uses signals "jerk", "direction" and, at
/// other joints that are `coupled`, the response to the rate. `friction` [N m or N]: what the
/// effort leaves out and turns with the direction, too.
Candidate sensor_low_pass_candidate(const EffectPlace& place, const EffortModel& effort,
                                    const std::vector<int>& coupled, double friction);

/// The logged position is wrong by a constant: gravity and the inertia of further links show it.
/// Uses, at other joints that are `coupled`, the response to an offset.
Candidate sensor_offset_candidate(const EffectPlace& place, const EffortModel& effort,
                                  const std::vector<int>& coupled);

/// The logged position is a constant share too large or too small. Uses, at other joints that are
/// `coupled`, the response to the position.
Candidate sensor_scale_candidate(const EffectPlace& place, const EffortModel& effort,
                                 const std::vector<int>& coupled);

/// The logged position has steps so coarse that its acceleration is them. Uses signals "smooth_q",
/// "smooth_qd" and "smooth_qdd", the motion as it may have been between the steps, and the column
/// of the mass matrix. Acts on the joints `coupled`, this one among them.
Candidate sensor_quantisation_candidate(const EffectPlace& place, const EffortModel& effort,
                                        const std::vector<int>& coupled);

/// The same for noise of another kind.
Candidate sensor_noise_candidate(const EffectPlace& place, const EffortModel& effort,
                                 const std::vector<int>& coupled);

/// The logged position follows the true one with play. Uses signals "side", "side_rate" and
/// "side_acceleration" and, at other joints that are `coupled`, the column of the mass matrix and
/// the response to an offset.
Candidate sensor_hysteresis_candidate(const EffectPlace& place, const EffortModel& effort,
                                      const std::vector<int>& coupled, const LogScale& scale);

}  // namespace sinew::diagnosis
