// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates with standard errors that hold for coloured noise and damped weights.
#pragma once

#include "identification/diagnosis/verdict.h"
#include "identification/regression/noise_model.h"

namespace sinew::diagnosis {

/// What is known of the noise: one smooth spectrum of each log and channel; or beside that how much
/// stretches of time differ (clustered_errors.h), of which the larger error counts.
enum class NoiseErrors { of_spectrum, of_stretches_too };

/// All parameters of every term, the term's order kept: linear ones first, then nonlinear ones.
/// The covariance is the sandwich (A'A)^-1 A' N A (A'A)^-1 with N the weighted noise's spectrum;
/// nonlinear parameters enter A with the derivative of the prediction.
std::vector<std::vector<ParameterEstimate>> estimates(
    const Design& design, const Model& model, const NoiseView& noise,
    NoiseErrors errors = NoiseErrors::of_spectrum);

}  // namespace sinew::diagnosis
