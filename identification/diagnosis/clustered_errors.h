// SPDX-License-Identifier: GPL-3.0-or-later
// Standard errors where what is left over is no noise of one spectrum.
#pragma once

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Covariance of least-squares coefficients by the scores of stretches of a log's time, in which
/// what is left over may have any correlation, all channels together (Liang and Zeger), each
/// corrected for what the fit has taken of it (Bell and McCaffrey's CR2). What is left over may
/// come and go with the motion, and then it is where the columns are, too, which no spectrum shows.
/// `columns`: whitened, all rows of the stack x coefficients; `residual`: what their fit leaves;
/// `gram`: columns' columns, with priors.
Eigen::MatrixXd covariance_by_stretches(const Design& design, const Stack& stacked,
                                        const Eigen::MatrixXd& columns,
                                        const Eigen::VectorXd& residual,
                                        const Eigen::MatrixXd& gram);

}  // namespace sinew::diagnosis
