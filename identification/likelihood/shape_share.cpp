// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/shape_share.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Derivatives of what a term says by steps of its parameters, per segment.
std::vector<MatrixXd> rates_of(const FittedModel& fitted, std::size_t term) {
  const Term& of = fitted.model.terms[term];
  const std::vector<Index> first = first_columns(fitted.model);
  const VectorXd coefficients =
      fitted.fit.coefficients.segment(first[term], first[term + 1] - first[term]);
  std::vector<MatrixXd> rates(fitted.weights.size());
  for (Index p = 0; p < of.nonlinear.size(); ++p) {
    const double step =
        of.candidate->nonlinear[static_cast<std::size_t>(p)].step_at(of.nonlinear(p));
    if (step == 0.0) continue;
    const BandColumns rate = shape_rate(fitted.design, of, p, coefficients);
    for (std::size_t s = 0; s < rates.size(); ++s) {
      if (fitted.weights[s].size() == 0 || rate[s].cols() == 0) continue;
      rates[s].conservativeResize(rate[s].rows(), rates[s].cols() + 1);
      rates[s].rightCols(1) = step * fitted.weights[s].cwiseProduct(rate[s].col(0));
    }
  }
  return rates;
}

}  // namespace

double log_share_of_step(const FittedModel& fitted, std::size_t term) {
  const std::vector<MatrixXd> rates = rates_of(fitted, term);
  Index wide = 0;
  for (const MatrixXd& rate : rates) wide = std::max(wide, rate.cols());
  if (wide == 0) return 0.0;
  MatrixXd precision = MatrixXd::Zero(wide, wide);
  MatrixXd cross = MatrixXd::Zero(fitted.stacked.coefficients, wide);
  for (std::size_t s = 0; s < rates.size(); ++s) {
    if (rates[s].cols() == 0) continue;
    precision += rates[s].transpose() * rates[s];
    cross(fitted.stacked.at[s], Eigen::all) += fitted.stacked.a[s].transpose() * rates[s];
  }
  precision -= cross.transpose() * fitted.fit.covariance * cross;
  // What the coefficients can say instead is left as it was.
  precision.diagonal().array() += 1e-9 * precision.diagonal().array().abs() + 1e-12;
  const Eigen::LLT<MatrixXd> factor(precision);
  if (factor.info() != Eigen::Success) return 0.0;
  const VectorXd root = MatrixXd(factor.matrixL()).diagonal();
  const double all = 0.5 * std::log(2.0 * std::numbers::pi);
  return (all - root.array().log()).min(0.0).sum();
}

}  // namespace sinew::diagnosis
