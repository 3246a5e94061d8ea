// SPDX-License-Identifier: GPL-3.0-or-later
// Which candidates these logs cannot tell apart, and the experiment that would.
#pragma once

#include <string>
#include <vector>

#include "identification/select.h"
#include "identification/verdict.h"

namespace sinew::diagnosis {

/// Largest canonical correlation of two column groups in the weighted band after the columns of
/// `model` are projected out: 1 where one group can stand in for the other.
double canonical_correlation(const Model& model, const Weights& weights, const BandColumns& a,
                             const BandColumns& b);

/// The cause in term `term` and every candidate that explains its part about as well, best first.
/// A rival belongs to the set where its deviance is behind by less than chance and the model's own
/// imperfection allow, or where the paired block differences do not speak against it.
struct Rivals {
  std::vector<RankedCause> members;
  double margin = 0.0;  ///< how far behind the best candidate outside the set is, deviance
  Model model;          ///< with the first member in the term's place
};
Rivals find_rivals(const Design& design, const Library& library, const Settings& settings,
                   const Selection& state, std::size_t term);

/// A planned experiment: its motion, without a target.
struct PlannedExperiment {
  std::string name;
  Recording motion;
};

/// Expected squared separation of two fitted causes on a planned motion: what is left of the
/// first's prediction after the baseline and the second are fitted to it, over the noise variance
/// per sample. first_coefficients: one for each of the first candidate's linear parameters.
double expected_separation(const Problem& problem, const Settings& settings, const Term& first,
                           const Eigen::VectorXd& first_coefficients, const Candidate& second,
                           const PlannedExperiment& experiment, double noise_variance);

}  // namespace sinew::diagnosis
