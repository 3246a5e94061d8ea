// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted functions as functions of Eigen vectors.
#pragma once

#include <Eigen/Core>
#include <initializer_list>

#include "tests/reference/emitted_model.h"

namespace sinew::reference {

class EmittedFunctions {
 public:
  explicit EmittedFunctions(const EmittedModel& model) : model_(model) {}

  /// The function's single result, shaped as the catalogue says.
  Eigen::MatrixXd operator()(const std::string& name,
                             std::initializer_list<Eigen::VectorXd> arguments) const {
    const sinew_function& function = model_.function(name);
    std::vector<double> inputs;
    for (const Eigen::VectorXd& argument : arguments)
      inputs.insert(inputs.end(), argument.begin(), argument.end());
    const std::vector<double> results = model_.call(function, inputs);
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(results.data(), function.outputs[0].rows,
                                      function.outputs[0].cols);
  }

  bool offers(const std::string& name) const { return model_.find(name) != nullptr; }

 private:
  const EmittedModel& model_;
};

/// Derivative at 0 of a matrix-valued function of one number, by central differences of order 8:
/// error about 1e-3 (w step)^8 |value| for motions of frequency w, and 2^-53 |value| / step.
template <class Function>
Eigen::MatrixXd derivative_at_zero(const Function& value, double step) {
  const double weights[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  Eigen::MatrixXd sum = weights[0] * (value(step) - value(-step));
  for (int k = 2; k <= 4; ++k) sum += weights[k - 1] * (value(k * step) - value(-k * step));
  return sum / step;
}

}  // namespace sinew::reference
