// SPDX-License-Identifier: GPL-3.0-or-later
// Forward selection by physical group, with swaps, pruning and joint re-fits.
#pragma once

#include <string>
#include <vector>

#include "identification/cross_validation.h"
#include "identification/screening.h"

namespace sinew {

/// What one accepted cause rests on.
struct Evidence {
  double statistic = 0.0;  ///< drop of the whitened deviance when it is left out
  double p_family = 1.0;   ///< family-wise, against surrogates, at the step that took it
  double freedom = 1.0;    ///< its null's mean statistic
  double validated = 0.0;  ///< drop of the whitened block-cross-validated loss
  Gain gain;               ///< of the plain cross-validated loss
};

/// Why a candidate is not in the model.
struct Refusal {
  int candidate = 0;
  std::string reason;
};

/// State of the search.
struct Selection {
  Model model;
  std::vector<NoiseModel> noise;
  Weights weights;
  std::vector<Eigen::MatrixXf> surrogates;
  Screening last;                      ///< the library on top of the final model
  std::vector<double> freedom;         ///< per candidate, from the first screening
  std::vector<double> first_surprise;  ///< per candidate, alone on the baseline
  std::vector<Refusal> refused;
  int swaps_left = 0;              ///< guards against going round in circles
  std::vector<Evidence> evidence;  ///< per term of the model; baseline terms' stay empty
};

/// Deviance minus this is what models are compared by: each effective parameter costs ln(rows).
double complexity_price(const Design& design);

/// Model of the baseline alone.
Model baseline_model(const Design& design);

/// Index of a term's candidate in the library, -1 for baseline terms.
int library_index(const Design& design, const Term& term);

/// True where a linear coefficient lies beyond its limit by more than two standard errors.
bool violates_limits(const Design& design, const Model& model, const LinearFit& fit,
                     std::size_t term);

/// Noise model, weights and surrogates for the present model.
void renew_noise(const Design& design, const Library& library, const Settings& settings,
                 Selection& state);

/// The whole search over named and decoy candidates; flexible ones are left to unexplained.h.
Selection select_causes(const Design& design, const Library& library, const Settings& settings);

}  // namespace sinew
