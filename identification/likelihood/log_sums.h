// SPDX-License-Identifier: GPL-3.0-or-later
// One log's sums, made so that those of many logs add up: every log has the same columns.
#pragma once

#include <string>
#include <vector>

#include "identification/likelihood/column_sums.h"
#include "identification/likelihood/fitted_baseline.h"
#include "identification/likelihood/noise_spectrum_fit.h"

namespace sinew::diagnosis {

/// What a likelihood asks of one log, or of several together.
struct LogSums {
  ColumnSums columns;  ///< each log's rows whitened by the spectrum of its own noise, which a short
                       ///< log has from the reference logs but for its level
  Eigen::VectorXd error;  ///< per channel: squares of what the model leaves before any cause
  void add(const LogSums& other);
};

/// The columns that reference logs decide: the ranges that grids and splines are spread over, and
/// how friction turns at a reversal. A coefficient that may differ from log to log (a ripple's
/// phase over an incremental encoder) is one for all logs here.
class ReferenceColumns {
 public:
  /// `problem`: prepared for the reference logs, its training logs; others are left away. Throws
  /// std::invalid_argument where channels share their noise: a log's sums whiten each channel by
  /// itself.
  ReferenceColumns(Problem problem, const Settings& settings);
  ReferenceColumns(const ReferenceColumns&) = delete;
  ReferenceColumns& operator=(const ReferenceColumns&) = delete;

  const Problem& problem() const { return problem_; }
  const Settings& settings() const { return settings_; }
  /// With the columns of the reference logs.
  const Hypotheses& hypotheses() const { return hypotheses_; }
  /// SHA-256 of every hypothesis' name, place, shapes and limits, and of the free part's terms.
  std::string hash() const;

  /// The sums of one log, whose stretches these are: prepared beside the reference logs as held-out
  /// logs are. Throws std::invalid_argument where no stretch is long enough, and where the log has
  /// not the columns of the reference logs.
  LogSums sums(std::vector<Recording> log) const;

 private:
  Problem problem_;
  Settings settings_;
  std::vector<BaselineShape> baseline_;
  ExpectedSpectra noise_;  ///< the reference logs'
  Hypotheses hypotheses_;
};

}  // namespace sinew::diagnosis
