// SPDX-License-Identifier: GPL-3.0-or-later
// The frequency band all fits are done in.
//
// A column of n samples becomes 2 * bins numbers, (real, imaginary) of the bins 0..bins-1, scaled
// so that their sum of squares is the column's energy inside the band (Parseval). There coloured
// stationary noise has a diagonal covariance, so whitening is one weight a bin (Whittle), and what
// the filter's stop band holds is left out.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// samples x k -> 2 * bins x k. The number of samples must be even.
Eigen::MatrixXd to_band(const Eigen::MatrixXd& x, Eigen::Index bins);

/// The inverse, band-limited: 2 * bins x k -> samples x k.
Eigen::MatrixXd from_band(const Eigen::MatrixXd& band, Eigen::Index samples);

/// 1, less over the first and last twentieth (cosine bells): to_band() takes a stretch of a log for
/// one period, and where slow noise leaps from its end to its beginning, the bins of that leap are
/// not independent. Seen at noise of second order above 1 Hz: a drift of friction at odds of e^34
/// in a log that had none.
Eigen::VectorXd end_taper(Eigen::Index samples);

/// Repeats a value per bin for the real and the imaginary row.
Eigen::VectorXd per_row(const Eigen::VectorXd& per_bin);

/// Energy per bin: real^2 + imaginary^2.
Eigen::VectorXd bin_energy(const Eigen::VectorXd& band);

/// Running mean numerator / denominator over a window that grows with frequency (half width
/// max(least, share * bin)), as a physical spectrum varies on a logarithmic frequency scale.
Eigen::VectorXd smooth_ratio(const Eigen::VectorXd& numerator, const Eigen::VectorXd& denominator,
                             Eigen::Index least, double share);

}  // namespace sinew::diagnosis
