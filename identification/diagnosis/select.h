// SPDX-License-Identifier: GPL-3.0-or-later
// Forward selection by physical group, with swaps, pruning and joint re-fits.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "identification/regression/cross_validation.h"
#include "identification/regression/trial.h"

namespace sinew::diagnosis {

/// What one accepted cause rests on.
struct Evidence {
  double statistic = 0.0;    ///< drop of the whitened deviance when it is left out
  double p_family = 1.0;     ///< family-wise, against surrogates of what the causes leave over
  double freedom = 1.0;      ///< its null's mean statistic
  double validated = 0.0;    ///< drop of the whitened block-cross-validated loss
  double of_baseline = 0.0;  ///< drop of the plain loss as a share of the baseline's
  Gain gain;                 ///< of the plain cross-validated loss, both in the term's channels
};

/// Why a candidate is not in the model.
struct Refusal {
  int candidate = 0;
  std::string reason;
};

/// State and result of the search.
struct Selection {
  Model model;
  NoiseView noise;              ///< seen from the model
  std::vector<double> freedom;  ///< per candidate of the library
  Screening first;              ///< the library on the baseline
  Screening last;               ///< the library on top of the final model
  std::vector<Refusal> refused;
  std::vector<Evidence> evidence;  ///< per term of the model; baseline terms' stay empty
  std::vector<double> p_family;    ///< per candidate, at the step that took it
  Eigen::VectorXd baseline_loss;   ///< plain cross-validated loss of the baseline, per channel
  std::vector<int> exchanged;      ///< candidates that values of the model were given up for
  std::vector<Term> deviations;    ///< select_deviations(): every deviation of the problem
  std::vector<std::shared_ptr<const Candidate>> made;  ///< what those terms point to
};

/// Evidence for one term of the model.
Evidence judge(const Design& design, const Settings& settings, const Selection& state,
               std::size_t term);

/// The whole search over named and decoy candidates; flexible ones are left to unexplained.h.
Selection select_causes(const Design& design, const Library& library, const Settings& settings);

/// What the library and each cause of a final model come to.
void conclude(const Design& design, const Library& library, const Settings& settings,
              Selection& state);

}  // namespace sinew::diagnosis
