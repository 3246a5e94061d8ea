// SPDX-License-Identifier: GPL-3.0-or-later
// What the forms of causes that were found are off by counts as noise.
#pragma once

#include "identification/likelihood/noise_spectrum_fit.h"
#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// The noise, and besides, for each of a model's terms from `first` on whose law has one form,
/// kFormError of what it says beyond what `free` can say, near the frequencies where that is large:
/// a law's form is in how it differs from the model with other values. Parts that undo each other
/// say nothing.
Whitening with_form_errors(const Whitening& noise, const Model& model, std::size_t first,
                           Model free);

}  // namespace sinew::diagnosis
