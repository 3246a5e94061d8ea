// SPDX-License-Identifier: GPL-3.0-or-later
// The model before any cause, as the likelihood starts from it.
#pragma once

#include <vector>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// The model's own terms, how friction turns at a reversal among them, fitted to the training logs.
Model fitted_baseline(const Design& design);

/// A term of the baseline without its columns: which candidate, and its nonlinear parameters.
struct BaselineShape {
  bool of_library = false;    ///< a nuisance of the library, or a term of the problem's baseline
  std::size_t candidate = 0;  ///< index into that list
  Eigen::VectorXd nonlinear;
};

/// What there is to keep of a fitted baseline for other logs of the same problem.
std::vector<BaselineShape> shapes_of(const Problem& problem, const Model& baseline);

/// The baseline of those shapes with the columns of this design's logs.
Model baseline_with(const Design& design, const std::vector<BaselineShape>& shapes);

}  // namespace sinew::diagnosis
