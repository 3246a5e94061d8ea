// SPDX-License-Identifier: GPL-3.0-or-later
// A cause's shape parameters begun elsewhere: a fit ends in the nearest minimum.
#pragma once

#include <functional>

#include "identification/regression/trial.h"

namespace sinew::diagnosis {

/// Whether anything is searched for beside its coefficients.
bool is_free(const NonlinearParameter& p);
bool has_free_shape(const Term& term);

/// The model with the shape of a cause begun elsewhere, or in another form of the same cause, where
/// that explains more and keeps the cause's limits. Only terms that `asked` says are looked at;
/// deviations and the baseline never are.
Model best_form(const Design& design, const Weights& weights, const Model& model,
                const std::function<bool(const Term&)>& asked);

}  // namespace sinew::diagnosis
