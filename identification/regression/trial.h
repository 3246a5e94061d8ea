// SPDX-License-Identifier: GPL-3.0-or-later
// One more cause in a model: fitted, held against its limits, and compared with its rivals.
#pragma once

#include <vector>

#include "identification/regression/screening.h"

namespace sinew::diagnosis {

/// Noise as seen from one model: spectrum and level, what they whiten with, and surrogates.
struct NoiseView {
  std::vector<NoiseModel> noise;
  Weights weights;
  std::vector<Eigen::MatrixXf> surrogates;
};

/// Noise left over by a model alone: whatever it does not explain counts as noise.
NoiseView own_noise(const Design& design, const Model& model);

/// Noise left over by the model and the whole library together, see estimate_noise().
NoiseView saturated_noise(const Design& design, const Library& library, const Model& model);

void draw_surrogates(const Design& design, const Settings& settings, NoiseView& view);

/// A model with one more cause.
struct Trial {
  int candidate = 0;
  Model model;
  bool allowed = false;
  std::string refusal;  ///< where not allowed: what the violated limit says
  double deviance = 0.0;
  double score = 0.0;  ///< deviance plus the price of its parameters: smaller is better
};

/// Deviance that chance may put an unlikely cause ahead of a likely one.
inline constexpr double kUnlikely = 12.0;

/// What an effective parameter costs when models are compared: the logarithm of the number of
/// independent rows.
double parameter_price(const Design& design);

/// Index of a term's candidate in the library, -1 for baseline terms and -1 - i for deviation i.
int library_index(const Design& design, const Term& term);

/// Price of all causes of a model; freedom: effective parameters per candidate.
double model_price(const Design& design, const std::vector<double>& freedom, const Model& model);

/// True where a linear coefficient lies beyond its limit by more than two standard errors, a delay
/// stands at a bound, or the effect has no such coefficients.
bool is_beyond_limits(const Design& design, const Model& model, const LinearFit& fit,
                      std::size_t term);

/// The same, or no body has the parameters of one.
bool violates_limits(const Design& design, const Model& model, const LinearFit& fit,
                     std::size_t term);

double deviance(const Model& model, const Weights& weights);

/// Named and decoy candidates of a screening that are worth a nonlinear fit, best first.
std::vector<Screened> shortlist(const Design& design, const std::vector<double>& freedom,
                                const Model& model, const Screening& screening, std::size_t most);

/// Fits every candidate of the list on top of `base`.
std::vector<Trial> try_candidates(const Design& design, const Weights& weights, const Model& base,
                                  const std::vector<Screened>& list);

/// Position of the best allowed trial under these weights (fills deviance and score), or -1.
int rank_trials(const Design& design, const std::vector<double>& freedom, const Weights& weights,
                std::vector<Trial>& trials);

}  // namespace sinew::diagnosis
