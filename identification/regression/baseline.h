// SPDX-License-Identifier: GPL-3.0-or-later
// The model before any cause: its own terms, and what is in every measurement.
#pragma once

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Model of the baseline alone. Every nonlinear parameter is where it starts best.
Model baseline_model(const Design& design);

/// Takes out the nuisances with a physical limit (how friction turns at a reversal) that stay
/// beyond it from every start, and those that the training logs do not show. To be called with a
/// refined model.
void settle_nuisances(const Design& design, const Weights& weights, Model& model);

}  // namespace sinew::diagnosis
