// SPDX-License-Identifier: GPL-3.0-or-later
// Standard errors where what is left over is no noise of one spectrum.
#pragma once

#include <vector>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Stretches of time, of all logs together, in each of which what is left over may be anything: a
/// stroke's misfit ends in the stretch that it began in, and there are enough of them for a
/// standard error within a sixth.
inline constexpr int kStretches = 20;

/// Covariance of least-squares coefficients by the scores of stretches of a log's time, in which
/// what is left over may have any correlation, all channels together (Liang and Zeger), each
/// corrected for what the fit has taken of it (Bell and McCaffrey's CR2). What is left over may
/// come and go with the motion, and then it is where the columns are, too, which no spectrum shows.
/// `shapes`: columns behind the stack's, whitened, all rows; `residual`: what the fit leaves;
/// `gram`: products of all columns, with priors.
Eigen::MatrixXd covariance_by_stretches(const Design& design, const Stack& stacked,
                                        const std::vector<Eigen::VectorXd>& shapes,
                                        const Eigen::VectorXd& residual,
                                        const Eigen::MatrixXd& gram);

/// A segment's rows of the stack's columns that act there and of all columns behind them.
struct ActingRows {
  Eigen::MatrixXd a;
  std::vector<Eigen::Index> at;  ///< the coefficient of each column
};
ActingRows acting_rows(const Stack& stacked, const std::vector<Eigen::VectorXd>& shapes,
                       std::size_t segment);

}  // namespace sinew::diagnosis
