// SPDX-License-Identifier: GPL-3.0-or-later
// What the form of a cause leaves open about its size.
#pragma once

#include "identification/diagnosis/verdict.h"
#include "identification/regression/noise_model.h"

namespace sinew::diagnosis {

/// estimates() with all that is known of their errors, as they are told and written to files;
/// decisions go by the noise of one spectrum alone. What stretches of time say of it counts, and
/// where a cause has its size twice, their difference: of two values that are equally likely to be
/// the right one the mean square error of either is half of their difference's square.
std::vector<std::vector<ParameterEstimate>> told_estimates(const Design& design, const Model& model,
                                                           const NoiseView& noise);

}  // namespace sinew::diagnosis
