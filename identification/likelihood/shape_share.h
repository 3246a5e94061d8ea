// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a fitted shape's prior the logs leave to it.
#pragma once

#include "identification/likelihood/hypotheses.h"

namespace sinew::diagnosis {

/// A model's fit, by which shares are asked for.
struct FittedModel {
  const Design& design;
  const Weights& weights;
  const Model& model;
  Stack stacked;
  LinearFit fit;

  FittedModel(const Design& d, const Weights& w, const Model& m)
      : design(d), weights(w), model(m), stacked(stack(m, w)), fit(solve(stacked)) {}
};

/// log of the share of the distance between two points of the grid, in each nonlinear parameter,
/// that the logs allow a fitted term beside the model's other coefficients (Laplace's
/// approximation); at most 0. A point of the grid stands for all about it, a shape that fits at one
/// value alone for that much less.
double log_share_of_step(const FittedModel& fitted, std::size_t term);

}  // namespace sinew::diagnosis
