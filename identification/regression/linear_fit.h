// SPDX-License-Identifier: GPL-3.0-or-later
// Generalised least squares over whitened band columns, and the model it is done for.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "identification/regression/design.h"

namespace sinew::diagnosis {

/// A group that takes part in the fit, at given nonlinear parameters.
struct Term {
  const Candidate* candidate = nullptr;
  bool baseline = false;
  Eigen::VectorXd nonlinear;
  SharedColumns columns;  ///< unwhitened
  int deviation = -1;     ///< index into the problem's deviations
  /// What was known of its parameters before the logs counts: it competes with values of the model.
  bool with_prior = false;
};

/// What a model says with coefficients that are not fitted, per segment in the band.
struct FixedPart {
  std::vector<Eigen::VectorXd> value, rate;  ///< empty: nothing
};

/// Baseline terms and accepted causes. A delay's term holds the model's time derivative; what it
/// has found so far is in `advance`: the target is taken that much later than the model's time.
struct Model {
  std::vector<Term> terms;
  std::vector<double> advance;          ///< s, per segment
  std::vector<Eigen::VectorXd> target;  ///< in the band, at that advance, less what is fixed
  FixedPart fixed;
};

/// Per segment: what each band row is multiplied with, 1 / the noise's (damped) standard deviation
/// there. Empty for held-out logs.
using Weights = std::vector<Eigen::VectorXd>;
/// 1 everywhere in the training logs.
Weights even_weights(const Design& design);

/// Whitened band rows stacked over segments. Most terms act on few segments, so each segment keeps
/// only the columns that act there.
struct Stack {
  std::vector<Eigen::MatrixXd> a;             ///< per segment: its rows x its columns
  std::vector<std::vector<Eigen::Index>> at;  ///< per segment: the columns' coefficients, ascending
  Eigen::VectorXd y;                          ///< all rows
  Eigen::VectorXd prior;                      ///< prior_precision() of the model
  std::vector<Eigen::Index> first_row;        ///< of each segment, and the total at the end
  Eigen::Index coefficients = 0;
  Eigen::MatrixXd dense() const;  ///< all rows x all coefficients
  Eigen::MatrixXd gram() const;   ///< dense()' dense(), and the priors' precisions
};

/// Of every coefficient what was known before the logs, in so far as it counts: 1 / spread^2
/// (candidate.h), or 0.
Eigen::VectorXd prior_precision(const Model& model);

/// Result of a fit. Coefficients follow the terms, each term's as Design::coefficients lists them.
struct LinearFit {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;  ///< pseudo-inverse of the whitened normal matrix and the priors
  Eigen::VectorXd residual;    ///< whitened, stacked
  double deviance = 0.0;       ///< residual' residual + coefficients' prior coefficients
};

/// Column of each term's first coefficient, and the total at the end.
std::vector<Eigen::Index> first_columns(const Model& model);

/// Moves a segment's target against the model's time.
void set_advance(const Design& design, std::size_t segment, double advance, Model& model);

/// Whitened training rows of all terms and the target.
Stack stack(const Model& model, const Weights& weights);

/// Least squares beside the priors; columns that are zero or linearly dependent get the
/// minimum-norm coefficients.
LinearFit solve(const Stack& stack);

/// The fit by an inverse of the normal matrix, given as what it makes of a moment; done twice,
/// since the normal equations square the condition number. Without covariance.
LinearFit refined_fit(const Stack& stack,
                      const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& inverse);

/// What the best fit of a model leaves.
double deviance(const Model& model, const Weights& weights);

/// True where a linear coefficient lies beyond its limit by more than two standard errors, a delay
/// stands at a bound, or the effect has no such coefficients.
bool is_beyond_limits(const Design& design, const Model& model, const LinearFit& fit,
                      std::size_t term);

/// The same, or no body has the parameters of one.
bool violates_limits(const Design& design, const Model& model, const LinearFit& fit,
                     std::size_t term);

/// Index of a term's candidate in the library, -1 for baseline terms and -1 - i for deviation i.
int library_index(const Design& design, const Term& term);

/// Model prediction of one segment in the band (derivative columns as given in `columns`).
Eigen::VectorXd predict(const std::vector<const BandColumns*>& columns,
                        const Eigen::VectorXd& coefficients, std::size_t segment);

/// Time derivative of every term's columns where `delay` acts (null: everywhere).
std::vector<SharedColumns> term_rates(const Design& design, const Model& model,
                                      const Candidate* delay = nullptr);

/// Time derivative of the model's prediction: the column a delay is linearised with. `rates`: of
/// term_rates().
BandColumns prediction_rate(const Design& design, const Model& model,
                            const std::vector<SharedColumns>& rates,
                            const Eigen::VectorXd& coefficients, const Candidate& delay);

}  // namespace sinew::diagnosis
