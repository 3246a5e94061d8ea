// SPDX-License-Identifier: GPL-3.0-or-later
// Which orders of a turning shaft an effort holds: its spectrum over the angle instead of over
// time (order analysis), in which what a tooth, a pole or a slot does is one line at any speed.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sinew::diagnosis {

/// A log tells orders where it turns the shaft so often: in less, a line is as wide as a quarter of
/// an order, and one between whole orders passes for one of them.
inline constexpr double kLeastTurns = 4.0;

/// A log as an order spectrum sees it.
struct ShaftLog {
  Eigen::VectorXd turns;   ///< of the shaft
  Eigen::VectorXd value;   ///< an effort, what varies slowly with the angle taken out of it
  Eigen::VectorXd counts;  ///< 1 in motion, 0 where the shaft rests or turns back
  /// Periods a sample at most by which a line's size is told: what is faster moves the masses, or
  /// is averaged over the sample, before the effort shows it.
  double fastest = 0.4;
};

/// A line in an order spectrum.
struct OrderLine {
  int order = 0;            ///< periods in a turn
  double prominence = 0.0;  ///< sum of the logs' energies at it, each over what noise has
  double chance = 1.0;      ///< that noise has one as large at any of the orders looked at
};

/// Lines at whole orders in [lowest, highest] of the logs' spectra together, the strongest first. A
/// line stands out of the median of all orders further than noise does in one of 10,000 searches,
/// and has its top at the whole order.
std::vector<OrderLine> order_lines(const std::vector<ShaftLog>& logs, int lowest, int highest);

/// One line's sine in one log, by least squares beside noise of the log's own spectrum.
struct LineFit {
  /// Of 2 pi order turns, in the effort's unit, by the samples in which the shaft makes less than
  /// ShaftLog::fastest of its periods; 0 where there are none.
  double sine = 0.0, cosine = 0.0;
  double sine_error = 0.0, cosine_error = 0.0;  ///< standard errors, by leaving blocks out
  /// Whitened sums of squares in equal blocks of time: without the line, and with the one that is
  /// fitted to the other blocks.
  Eigen::VectorXd without, with;
};
LineFit fit_line(const ShaftLog& log, int order, int blocks);

}  // namespace sinew::diagnosis
