// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates with standard errors that hold for coloured noise and damped weights.
#pragma once

#include "identification/regression/trial.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// All parameters of every term, the term's order kept: linear ones first, then nonlinear ones.
/// The covariance is the sandwich (A'A)^-1 A' N A (A'A)^-1 with N the weighted noise's spectrum;
/// nonlinear parameters enter A with the derivative of the prediction.
std::vector<std::vector<ParameterEstimate>> estimates(const Design& design, const Model& model,
                                                      const NoiseView& noise);

}  // namespace sinew::diagnosis
