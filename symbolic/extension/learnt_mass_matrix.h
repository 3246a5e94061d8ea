// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a model with what it has learnt still accelerates the way it is pushed.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "generator/range.h"
#include "symbolic/extension/driven_model.h"
#include "symbolic/extension/identified.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// States at which a mass matrix is looked at: the centre of the ranges, their corners (all of them
/// up to 8 coordinates, else 256 that a quasi-random sequence picks), and 64 quasi-random states.
std::vector<Eigen::VectorXd> workspace_samples(const std::vector<Range>& ranges);

/// Where the mass matrix (links, armatures, and what entries without memory add to a joint's
/// acceleration) is not positive definite at one of those states, though without the entries it is:
/// what is wrong, with the state and the entries to blame. `learnt`: with_identified() of the
/// mechanism; `motor`: of its tendons, where entries speak of them.
std::optional<std::string> why_not_definite(const Mechanism& learnt,
                                            const std::optional<MotorParameters>& motor,
                                            const Identified& identified);
/// Of a model that is one motor.
std::optional<std::string> why_not_definite(const DrivenModel& motor, const Identified& identified);

}  // namespace sinew
