// SPDX-License-Identifier: GPL-3.0-or-later
// The search on the moments, with the shapes of what it finds fitted between the grid's points.
#pragma once

#include <memory>
#include <vector>

#include "identification/likelihood/noise_spectrum_fit.h"
#include "identification/likelihood/slot_forms.h"

namespace sinew::diagnosis {

/// What was found, and all that it rests on.
struct FoundSlots {
  Hypotheses all;  ///< with one more shape for each that was fitted
  Whitening whitening;
  Moments moments;
  std::unique_ptr<SmallErrors> errors;  ///< points to `moments`
  std::unique_ptr<SlotSearch> search;   ///< points to all of these
  Slots slots;
  Model model;                 ///< the base's terms, then one term a slot, in their order
  double small_errors = 0.0;   ///< share by which everything is off
  std::vector<FoundLaw> laws;  ///< whose relatives are off by more
  double evidence = 0.0;       ///< log of the logs' probability and the slots' odds, to be compared
  std::vector<SlotForm> forms;  ///< what the next search begins from; empty: nothing
};

enum class Rivals { asked, left_out };

/// `baseline`: as for make_hypotheses(). `rivals`: whether the search begins again from those of
/// every slot. `beginning`: what another search of nearly the same logs has found; empty: nothing
/// is known yet.
std::unique_ptr<FoundSlots> find_slots(const Design& design, const Settings& settings,
                                       const Model& baseline, Rivals rivals,
                                       const std::vector<SlotForm>& beginning);

/// The search again without structure that has no name, from the names that were found on and under
/// their noise.
void search_names_alone(const Design& design, const Settings& settings, FoundSlots& found);

/// Per channel, the variance of a sample that is not material.
Eigen::VectorXd immaterial_variance(const Design& design, const Settings& settings,
                                    const Model& model);

}  // namespace sinew::diagnosis
