// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of a model before and after its causes, and what they gain.
#pragma once

#include "identification/diagnosis/selection.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// s: less motion of a joint in a log judges nothing.
inline constexpr double kLeastMotion = 0.5;

/// Root mean square of what a model leaves of each channel in the training logs, all frequencies
/// alike.
Eigen::VectorXd left_over(const Design& design, const Model& model);

/// A model with a term and without it, so that what the term explains is not taken over: beside a
/// value of the model itself bodies are held (held_bodies.h).
struct WithAndWithout {
  Model with, without;
};
WithAndWithout compared(const Design& design, const Model& model, std::size_t term,
                        const Weights& weights);

/// What a term gains on held-out logs beside the rest of the model, compared so.
Gain gain_on_held_out(const Design& design, const Settings& settings, const Selection& selection,
                      std::size_t term);

/// Fills in the verdict's errors before and after, what all causes together gain on held-out logs,
/// and takes back what is not material. `before`: the model without any cause.
void tell_errors(const Design& design, const Settings& settings, const Model& before,
                 const Selection& after, Verdict& verdict);

}  // namespace sinew::diagnosis
