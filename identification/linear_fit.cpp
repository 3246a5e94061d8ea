// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/linear_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Index width(const Term& term) {
  for (const MatrixXd& part : term.columns)
    if (part.cols() > 0) return part.cols();
  return 0;
}

}  // namespace

void set_advance(const Design& design, std::size_t segment, double advance, Model& model) {
  model.advance[segment] = advance;
  model.target[segment] = design.target(static_cast<int>(segment), advance);
  if (!model.fixed.value.empty()) model.target[segment] -= model.fixed.value[segment];
}

std::vector<Index> first_columns(const Model& model) {
  std::vector<Index> first{0};
  for (const Term& term : model.terms) first.push_back(first.back() + width(term));
  return first;
}

Stack stack(const Model& model, const Weights& weights) {
  Stack result;
  const std::vector<Index> first = first_columns(model);
  result.first_row.push_back(0);
  for (const VectorXd& weight : weights)
    result.first_row.push_back(result.first_row.back() + weight.size());
  result.a = MatrixXd::Zero(result.first_row.back(), first.back());
  result.y = VectorXd::Zero(result.first_row.back());
  for (std::size_t s = 0; s < weights.size(); ++s) {
    const Index rows = result.first_row[s + 1] - result.first_row[s];
    if (rows == 0) continue;
    result.y.segment(result.first_row[s], rows) = weights[s].cwiseProduct(model.target[s]);
    for (std::size_t t = 0; t < model.terms.size(); ++t) {
      const MatrixXd& part = model.terms[t].columns[s];
      if (part.cols() > 0)
        result.a.block(result.first_row[s], first[t], rows, part.cols()) =
            weights[s].asDiagonal() * part;
    }
  }
  return result;
}

MatrixXd scaled_pseudo_inverse(const MatrixXd& gram, double tolerance) {
  if (gram.size() == 0) return gram;
  const VectorXd scale =
      gram.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 0.0; });
  const MatrixXd unit = scale.asDiagonal() * gram * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(unit);
  const double limit = tolerance * std::max(eigen.eigenvalues().maxCoeff(), 1e-300);
  const VectorXd inverse =
      eigen.eigenvalues().unaryExpr([limit](double e) { return e > limit ? 1.0 / e : 0.0; });
  const MatrixXd v = scale.asDiagonal() * eigen.eigenvectors();
  return v * inverse.asDiagonal() * v.transpose();
}

LinearFit solve(const Stack& stack) {
  LinearFit fit;
  if (stack.a.cols() == 0) {
    fit.residual = stack.y;
  } else {
    fit.covariance = scaled_pseudo_inverse(stack.a.transpose() * stack.a);
    fit.coefficients = fit.covariance * (stack.a.transpose() * stack.y);
    fit.residual = stack.y - stack.a * fit.coefficients;
    // One step of refinement: the normal equations square the condition number.
    const VectorXd step = fit.covariance * (stack.a.transpose() * fit.residual);
    fit.coefficients += step;
    fit.residual -= stack.a * step;
  }
  fit.deviance = fit.residual.squaredNorm();
  return fit;
}

VectorXd predict(const std::vector<const BandColumns*>& columns, const VectorXd& coefficients,
                 std::size_t segment) {
  VectorXd sum;
  Index at = 0;
  for (const BandColumns* group : columns) {
    Index wide = 0;
    for (const MatrixXd& part : *group) wide = std::max(wide, part.cols());
    const MatrixXd& part = (*group)[segment];
    if (part.cols() > 0) {
      if (sum.size() == 0) sum = VectorXd::Zero(part.rows());
      sum += part * coefficients.segment(at, wide);
    }
    at += wide;
  }
  return sum;
}

BandColumns prediction_rate(const Design& design, const Model& model, const VectorXd& coefficients,
                            const Candidate& delay) {
  std::vector<BandColumns> rates;
  for (const Term& term : model.terms) {
    if (term.candidate->kind == CandidateKind::delay) {
      BandColumns none = term.columns;  // keeps the coefficient's place; its rate is second order
      for (MatrixXd& part : none) part.setZero();
      rates.push_back(std::move(none));
    } else {
      rates.push_back(design.columns(*term.candidate, term.nonlinear, 1));
    }
  }
  std::vector<const BandColumns*> all;
  for (const BandColumns& rate : rates) all.push_back(&rate);
  BandColumns result(design.segments().size());
  for (std::size_t s = 0; s < result.size(); ++s) {
    const int channel = design.segments()[s].channel;
    if (!delay.channels.empty() &&
        std::find(delay.channels.begin(), delay.channels.end(), channel) == delay.channels.end())
      continue;
    result[s] = predict(all, coefficients, s);
    const auto add = [&](const VectorXd& rate) {
      if (result[s].size() == 0)
        result[s] = rate;
      else
        result[s] += rate;
    };
    if (const std::optional<VectorXd> known = design.known(static_cast<int>(s), 1)) add(*known);
    if (!model.fixed.rate.empty()) add(model.fixed.rate[s]);
  }
  return result;
}

}  // namespace sinew::diagnosis
