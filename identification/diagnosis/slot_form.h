// SPDX-License-Identifier: GPL-3.0-or-later
// What a search has found in a form that another search begins from.
#pragma once

#include <Eigen/Core>
#include <string>

namespace sinew::diagnosis {

/// A cause or a value of the model's own as it was found. Entries of a search have other indexes
/// where shapes were added, hypotheses where another problem's library differs.
struct SlotForm {
  int candidate = 0;  ///< index into the library; deviation i of the problem is -1 - i
  std::string name, place;
  Eigen::VectorXd nonlinear;  ///< as fitted, or of the grid's point
  double variance = 0.0;      ///< prior variance of its coefficients, in the columns' scale
};

}  // namespace sinew::diagnosis
