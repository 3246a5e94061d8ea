// SPDX-License-Identifier: GPL-3.0-or-later
// What bodies change, held while another term's gain is measured.
#pragma once

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Whether it is a link's own parameters or a payload (Candidate::of_body).
bool is_of_body(const Term& term);

/// The model with such terms at their coefficients of the whole fit, as fixed parts. Set free, they
/// would take over what a term explains that is taken out, at whatever unlikely values that needs:
/// a link of thrice its mass moves a slide as a rotor does. The same model where there is none.
Model hold_bodies(const Design& design, const Model& model, const Weights& weights);

}  // namespace sinew::diagnosis
