// SPDX-License-Identifier: GPL-3.0-or-later
// Products of whitened columns with each other and with what a model leaves over: sums over rows,
// and so over logs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/likelihood/hypotheses.h"
#include "identification/likelihood/noise_spectrum_fit.h"
#include "identification/likelihood/regions.h"

namespace sinew::diagnosis {

/// All columns stand in their own units: first those of the model's free part, then every shape's
/// in the order of Hypotheses::shapes.
struct ColumnSums {
  Eigen::Index free = 0;            ///< columns of the model's free part
  std::vector<Eigen::Index> width;  ///< of every shape: its columns; 0 for one that acts nowhere
  RegionProducts gram;
  Eigen::VectorXd target;
  double deviance = 0.0;     ///< whitened squares of the target
  double rows = 0.0;         ///< independent real rows
  Eigen::MatrixXd energy;    ///< channels x shapes' columns: their squares, not whitened
  Eigen::VectorXd acting;    ///< of each of those columns the samples of the channels it acts on
  Eigen::VectorXd measured;  ///< per channel: squares of what was measured in the band
  Eigen::VectorXd samples;   ///< per channel: how many count
  std::vector<std::vector<int>> joined;  ///< channels that share their noise

  /// Of other logs. Throws std::invalid_argument where the columns are not as many.
  void add(const ColumnSums& other);
};

/// Of the training segments, each row whitened, what channels share of their noise as well.
/// `all.shapes` hold their columns.
ColumnSums column_sums(const Design& design, const Hypotheses& all, const Whitening& whitening);

/// Of the segments that have weights, each by itself.
ColumnSums column_sums(const Design& design, const Hypotheses& all, const Weights& weights);

}  // namespace sinew::diagnosis
