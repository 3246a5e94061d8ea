// SPDX-License-Identifier: GPL-3.0-or-later
// How far emitted C is from the reference, over many states.
#pragma once

#include <string>
#include <vector>

#include "tests/reference/emitted_model.h"
#include "tests/reference/reference_model.h"

namespace sinew::reference {

/// Worst case of one function.
struct Deviation {
  std::string function;
  /// |emitted - double Newton-Euler| / the result's largest entry at that state (at least 1 % of
  /// its scale); forward dynamics: also divided by the condition number of M at that state over the
  /// smallest one seen. Infinite where a result is not finite or the function is missing.
  double relative = 0.0;
  /// |emitted - 50-digit Newton-Euler| / (2^-53 scale), 2^-24 for a float model; forward dynamics:
  /// also divided by the condition number of M at that state. scale: the output's largest entry
  /// over all states.
  double units = 0.0;
  double scale = 0.0;
  int worst_state = 0;  ///< where `units` was found
};

struct ComparisonSize {
  int states = 10000;      ///< compared in double
  int exact_states = 400;  ///< the first of them, compared with 50 digits
  std::uint64_t seed = 1;
};

/// All functions that offered_functions names.
std::vector<Deviation> compare(const EmittedModel& emitted, const Mechanism& mechanism,
                               const ComparisonSize& size = {});

/// A table to print beside a failure.
std::string describe(const std::vector<Deviation>& deviations);

/// Condition number of a symmetric positive definite matrix.
double condition_number(const Eigen::MatrixXd& matrix);

}  // namespace sinew::reference
