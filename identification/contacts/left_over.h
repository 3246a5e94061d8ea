// SPDX-License-Identifier: GPL-3.0-or-later
// What a model leaves over in time, some stretches set aside.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Of one recording the samples that are set aside.
using SetAside = Eigen::ArrayX<bool>;

/// What a model leaves over of one recording, all channels at the same instants.
struct LeftOver {
  int recording = 0;  ///< index into training, then holdout
  bool held_out = false;
  Eigen::VectorXd time;         ///< s, of the log's own clock
  Eigen::MatrixXd measured;     ///< samples x channels, N m or N
  Eigen::MatrixXd residual;     ///< the same: measured less what the model says
  Eigen::MatrixXd explained;    ///< the same: what the named causes of the model make of it
  Eigen::MatrixXd within_step;  ///< the same: how far what the model says goes in a step of the log
  /// The same: standard error of what the model says where it is not fitted, set aside; else 0.
  Eigen::MatrixXd extrapolated;
  Eigen::MatrixXd counts;              ///< the same: 1, and down to 0 where a joint stands still
  Eigen::MatrixXd position, velocity;  ///< of the channels' coordinates: rad or m, and per s
  double step = 0.0;                   ///< s: of the log
  double rate_hz = 0.0;                ///< of the samples
  double band_hz = 0.0;                ///< what is left over lies below
  double reach = 0.0;                  ///< s: over so much to each side the filter spreads an event
};

/// A design that compares every channel in one band, the narrowest that one of them has, at every
/// sample. Keeps a reference to the problem.
Design evenly_banded(const Problem& problem, Settings settings);

/// Least squares in time with the terms of a model, whose shapes and delays stay as they are.
class FitInTime {
 public:
  /// `design`: evenly banded; `model`: of a search over the same problem, or one that differs from
  /// it in what is left out of the recordings. Throws std::invalid_argument where a recording does
  /// not have all channels.
  FitInTime(const Design& design, const Model& model);

  Eigen::Index samples(std::size_t recording) const { return recordings_[recording].time.size(); }
  std::size_t recordings() const { return recordings_.size(); }
  /// rms of what was measured, per channel.
  Eigen::VectorXd measured_rms() const;

  /// What is left over, one entry a recording, by a fit to what is not set aside of the training
  /// logs, standstills aside. Errors of a channel count in units of its entry in `sizes`.
  std::vector<LeftOver> operator()(const std::vector<SetAside>& aside,
                                   const Eigen::VectorXd& sizes) const;

 private:
  /// No term is expected to make more than what is measured of a channel: what few samples tell of
  /// it could be anything in another log.
  void expect_no_more_than_measured();
  /// Of all coefficients, which begin at `first` for each term.
  Eigen::VectorXd columns_at(std::size_t segment, Eigen::Index sample,
                             const std::vector<Eigen::Index>& first) const;

  std::vector<LeftOver> recordings_;                ///< nothing taken off yet
  std::vector<std::pair<std::size_t, int>> place_;  ///< of each segment: recording and channel
  Model model_;               ///< its rows are samples in time, not in the band
  Eigen::VectorXd expected_;  ///< of each coefficient, 1 / spread^2
};

}  // namespace sinew::diagnosis
