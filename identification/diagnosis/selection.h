// SPDX-License-Identifier: GPL-3.0-or-later
// A model that was found, and the noise seen from it.
#pragma once

#include <memory>
#include <vector>

#include "identification/regression/noise_model.h"

namespace sinew::diagnosis {

struct Selection {
  Model model;
  NoiseView noise;                                     ///< seen from the model
  std::vector<std::shared_ptr<const Candidate>> made;  ///< what terms of deviations point to
};

}  // namespace sinew::diagnosis
