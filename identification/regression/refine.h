// SPDX-License-Identifier: GPL-3.0-or-later
// Joint re-fit: nonlinear parameters with Ceres, linear ones eliminated, delays by linearisation.
#pragma once

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Improves the model in place within the parameters' bounds. The linear coefficients are
/// eliminated at every evaluation (variable projection), so causes are always re-fitted together.
void refine(const Design& design, const Weights& weights, Model& model);

/// A term at given nonlinear parameters, with its columns.
Term make_term(const Design& design, const Candidate& candidate, const Eigen::VectorXd& nonlinear,
               bool baseline);

/// Derivative of what a term says by one of its nonlinear parameters: one column for each segment
/// of the training logs where it acts.
BandColumns shape_rate(const Design& design, const Term& term, Eigen::Index parameter,
                       const Eigen::VectorXd& coefficients);

/// Appends a term; a delay gets the time derivative of the model's present prediction, and the
/// target is moved by it.
void append_term(const Design& design, const Weights& weights, const Candidate& candidate,
                 const Eigen::VectorXd& nonlinear, Model& model);

/// Takes a term out; a delay's shift of the target goes with it.
void remove_term(const Design& design, std::size_t index, Model& model);

}  // namespace sinew::diagnosis
