// SPDX-License-Identifier: GPL-3.0-or-later
// Out-of-sample losses on contiguous blocks and on held-out logs.
#pragma once

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Sums of squared errors per block of what was predicted without that block.
struct BlockLosses {
  Eigen::MatrixXd plain;  ///< blocks x channels, in the squares of Design::unit, inside the band
  Eigen::VectorXd samples;

  /// Losses of the blocks over all channels.
  Eigen::VectorXd over_all() const { return plain.rowwise().sum(); }
};

/// 1 for the channels by whose errors a term is judged, else 0: those on which it acts, or all
/// where they share their noise.
Eigen::VectorXd channels_of(const Design& design, const Term& term);

/// Every training log is cut into contiguous blocks (about `blocks` over all logs); for each the
/// linear coefficients are fitted without it, nonlinear parameters are kept.
BlockLosses cross_validate(const Design& design, const Model& model, const Weights& weights,
                           int blocks);

/// The same on the held-out logs with the training's coefficients. Per-log nuisances are fitted
/// on the held-out log's other blocks.
BlockLosses held_out(const Design& design, const Model& model, const LinearFit& fit, int blocks);

/// A gain with its interval.
struct Gain {
  double share = 0.0;  ///< of the squared error that goes away: 1 - after / before
  double low = 0.0, high = 0.0;
};

/// Whitened errors of the held-out logs, as held_out() has them, of every segment; empty where it
/// is of the training. `whitening`: of the held-out segments.
std::vector<Eigen::VectorXd> held_out_errors(const Design& design, const Model& model,
                                             const LinearFit& fit, int blocks,
                                             const Weights& whitening);

/// What whitened errors gain, with an interval of 95 %: of two models, neither of them true, the
/// one with the larger likelihood (Vuong, Econometrica 57, 1989). The standard error of the sum of
/// e0^2 - e1^2 over all rows is the root of that of its squares. An effect that acts in bursts is
/// no less sure for that, as it would be were whole blocks drawn, and errors that come in bursts
/// with it make it less so.
Gain likelihood_gain(const std::vector<Eigen::VectorXd>& before,
                     const std::vector<Eigen::VectorXd>& after);

/// With the interval that resampling whole blocks gives. level: for instance 0.95.
Gain block_bootstrap_gain(const Eigen::VectorXd& before, const Eigen::VectorXd& after, double level,
                          unsigned seed);

/// Of a gain whose interval is of 95 %.
double standard_errors_above_zero(const Gain& gain);

/// To one side, 1.6 standard errors are sure.
bool is_sure(const Gain& gain);

}  // namespace sinew::diagnosis
