// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/linear_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/regression/body_limits.h"
#include "identification/regression/inner_loop.h"

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

Weights even_weights(const Design& design) {
  Weights even;
  for (const Segment& s : design.segments())
    even.push_back(s.holdout ? VectorXd() : VectorXd(VectorXd::Ones(2 * s.bins)));
  return even;
}

VectorXd prior_precision(const Model& model) {
  const std::vector<Index> first = first_columns(model);
  VectorXd precision = VectorXd::Zero(first.back());
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    if (!model.terms[t].with_prior) continue;
    const std::vector<LinearParameter>& linear = model.terms[t].candidate->linear;
    // Priors are of values that all logs share: a coefficient for each parameter.
    if (first[t + 1] - first[t] != static_cast<Index>(linear.size())) continue;
    for (std::size_t p = 0; p < linear.size(); ++p)
      if (linear[p].spread > 0.0)
        precision(first[t] + static_cast<Index>(p)) = 1.0 / (linear[p].spread * linear[p].spread);
  }
  return precision;
}

Stack stack(const Model& model, const Weights& weights) {
  Stack result;
  const std::vector<Index> first = first_columns(model);
  result.coefficients = first.back();
  result.prior = prior_precision(model);
  result.first_row.push_back(0);
  for (const VectorXd& weight : weights)
    result.first_row.push_back(result.first_row.back() + weight.size());
  result.a.resize(weights.size());
  result.at.resize(weights.size());
  result.y = VectorXd::Zero(result.first_row.back());
  inner_loop(weights.size(), [&](std::size_t s) {
    const Index rows = weights[s].size();
    if (rows == 0) return;
    result.y.segment(result.first_row[s], rows) = weights[s].cwiseProduct(model.target[s]);
    for (std::size_t t = 0; t < model.terms.size(); ++t)
      for (Index c = 0; c < model.terms[t].columns[s].cols(); ++c)
        result.at[s].push_back(first[t] + c);
    result.a[s].resize(rows, static_cast<Index>(result.at[s].size()));
    Index place = 0;
    for (const Term& term : model.terms) {
      const MatrixXd& part = term.columns[s];
      if (part.cols() == 0) continue;
      result.a[s].middleCols(place, part.cols()) = weights[s].asDiagonal() * part;
      place += part.cols();
    }
  });
  return result;
}

MatrixXd Stack::dense() const {
  MatrixXd all = MatrixXd::Zero(first_row.back(), coefficients);
  for (std::size_t s = 0; s < a.size(); ++s)
    for (std::size_t c = 0; c < at[s].size(); ++c)
      all.col(at[s][c]).segment(first_row[s], a[s].rows()) = a[s].col(static_cast<Index>(c));
  return all;
}

MatrixXd Stack::gram() const {
  std::vector<MatrixXd> own(a.size());
  inner_loop(a.size(), [&](std::size_t s) {
    own[s] = MatrixXd::Zero(a[s].cols(), a[s].cols());
    own[s].selfadjointView<Eigen::Lower>().rankUpdate(a[s].transpose());
  });
  MatrixXd sum = MatrixXd::Zero(coefficients, coefficients);
  for (std::size_t s = 0; s < a.size(); ++s)
    if (!at[s].empty()) sum(at[s], at[s]) += MatrixXd(own[s].selfadjointView<Eigen::Lower>());
  sum.diagonal() += prior;
  return sum;
}

namespace {

/// No eigenvalue is smaller than 1 / the inverse's norm nor larger than the matrix' own, so that
/// none counts as zero; twice for what rounding makes of the inverse.
bool is_regular(const MatrixXd& gram, const MatrixXd& inverse, double tolerance) {
  return 2.0 * tolerance * gram.norm() * inverse.norm() < 1.0;
}

/// Pivoted Cholesky factor of a matrix of unit diagonal, as far as there is more than rounding.
MatrixXd pivoted_factor(const MatrixXd& unit) {
  constexpr double kRounding = 1e-13;
  MatrixXd half(unit.rows(), unit.cols());
  VectorXd left = unit.diagonal();
  Index rank = 0, pivot = 0;
  for (; rank < unit.cols() && left.maxCoeff(&pivot) > kRounding; ++rank) {
    const double root = std::sqrt(left(pivot));
    half.col(rank) = unit.col(pivot);
    if (rank > 0) half.col(rank) -= half.leftCols(rank) * half.row(pivot).head(rank).transpose();
    half.col(rank) /= root;
    left -= half.col(rank).cwiseAbs2();
    left(pivot) = 0.0;
  }
  return half.leftCols(rank);
}

/// Pseudo-inverse of a matrix of unit diagonal without its eigenvectors. None: some eigenvalue is
/// so small that they have to tell whether it counts as zero.
std::optional<MatrixXd> pseudo_inverse_by_factor(const MatrixXd& unit, double tolerance) {
  const Eigen::LLT<MatrixXd> factor(unit);
  if (factor.info() == Eigen::Success) {
    const MatrixXd half = factor.matrixL().solve(MatrixXd::Identity(unit.rows(), unit.cols()));
    MatrixXd inverse = MatrixXd::Zero(unit.rows(), unit.cols());
    inverse.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
    inverse.triangularView<Eigen::StrictlyUpper>() = inverse.transpose();
    if (is_regular(unit, inverse, tolerance)) return inverse;
  }
  // Columns of a body that its joint does not move, or moves as others, depend on those exactly.
  const MatrixXd half = pivoted_factor(unit);
  const MatrixXd own = half.transpose() * half;
  const Eigen::LLT<MatrixXd> small(own);
  if (half.cols() == 0 || small.info() != Eigen::Success) return std::nullopt;
  const MatrixXd inverse = small.solve(MatrixXd::Identity(own.rows(), own.cols()));
  if (!is_regular(own, inverse, tolerance)) return std::nullopt;
  const MatrixXd root = half * inverse;
  return MatrixXd(root * root.transpose());
}

}  // namespace

MatrixXd scaled_pseudo_inverse(const MatrixXd& gram, double tolerance) {
  if (gram.size() == 0) return gram;
  const VectorXd scale =
      gram.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 0.0; });
  const MatrixXd unit = scale.asDiagonal() * gram * scale.asDiagonal();
  // The decomposition takes ten times as long and is for what is nearly dependent.
  if (const auto inverse = pseudo_inverse_by_factor(unit, tolerance))
    return scale.asDiagonal() * *inverse * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(unit);
  const double limit = tolerance * std::max(eigen.eigenvalues().maxCoeff(), 1e-300);
  const VectorXd inverse =
      eigen.eigenvalues().unaryExpr([limit](double e) { return e > limit ? 1.0 / e : 0.0; });
  const MatrixXd v = scale.asDiagonal() * eigen.eigenvectors();
  return v * inverse.asDiagonal() * v.transpose();
}

LinearFit solve(const Stack& stack) {
  LinearFit fit;
  fit.residual = stack.y;
  fit.coefficients = VectorXd::Zero(stack.coefficients);
  if (stack.coefficients > 0) {
    fit.covariance = scaled_pseudo_inverse(stack.gram());
    // Twice, for refinement: the normal equations square the condition number.
    for (int round = 0; round < 2; ++round) {
      std::vector<VectorXd> own(stack.a.size());
      inner_loop(own.size(), [&](std::size_t s) {
        own[s] =
            stack.a[s].transpose() * fit.residual.segment(stack.first_row[s], stack.a[s].rows());
      });
      VectorXd moment = -stack.prior.cwiseProduct(fit.coefficients);
      for (std::size_t s = 0; s < own.size(); ++s)
        if (!stack.at[s].empty()) moment(stack.at[s]) += own[s];
      const VectorXd step = fit.covariance * moment;
      fit.coefficients += step;
      inner_loop(own.size(), [&](std::size_t s) {
        if (!stack.at[s].empty())
          fit.residual.segment(stack.first_row[s], stack.a[s].rows()) -=
              stack.a[s] * step(stack.at[s]);
      });
    }
  }
  fit.deviance = fit.residual.squaredNorm() + stack.prior.dot(fit.coefficients.cwiseAbs2());
  return fit;
}

double deviance(const Model& model, const Weights& weights) {
  return solve(stack(model, weights)).deviance;
}

bool is_beyond_limits(const Design& design, const Model& model, const LinearFit& fit,
                      std::size_t term) {
  const Term& t = model.terms[term];
  if (t.candidate->kind == CandidateKind::delay) {
    const NonlinearParameter& range = t.candidate->nonlinear.front();
    return t.nonlinear(0) <= range.low || t.nonlinear(0) >= range.high;
  }
  const auto layout = design.coefficients(*t.candidate);
  const Index first = first_columns(model)[term];
  for (std::size_t c = 0; c < layout.size(); ++c) {
    const LinearParameter& p = t.candidate->linear[static_cast<std::size_t>(layout[c].parameter)];
    const Index at = first + static_cast<Index>(c);
    // The slack forgives a wrong side by chance only.
    const double slack = 2.0 * std::sqrt(std::max(0.0, fit.covariance(at, at)));
    const double value = fit.coefficients(at);
    if (value < p.low - slack || value > p.high + slack) return true;
  }
  if (!t.candidate->possible) return false;
  const auto wide = static_cast<Index>(layout.size());
  return !t.candidate->possible(fit.coefficients.segment(first, wide), t.nonlinear);
}

bool violates_limits(const Design& design, const Model& model, const LinearFit& fit,
                     std::size_t term) {
  if (is_beyond_limits(design, model, fit, term)) return true;
  const std::optional<double>& within = model.terms[term].candidate->body_within;
  if (!within) return false;
  const auto n = static_cast<Index>(design.coefficients(*model.terms[term].candidate).size());
  const Index first = first_columns(model)[term];
  const VectorXd errors = fit.covariance.diagonal().segment(first, n).cwiseMax(0.0).cwiseSqrt();
  return !is_body(fit.coefficients.segment(first, n), errors, *within);
}

int library_index(const Design& design, const Term& term) {
  const std::vector<Candidate>& library = design.problem().library;
  if (term.deviation >= 0) return -1 - term.deviation;
  return term.baseline || library.empty() ? -1 : static_cast<int>(term.candidate - library.data());
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

std::vector<SharedColumns> term_rates(const Design& design, const Model& model,
                                      const Candidate* delay) {
  std::vector<SharedColumns> rates;
  for (const Term& term : model.terms) {
    bool wanted = false;
    for (std::size_t s = 0; s < term.columns.size(); ++s)
      wanted |=
          term.columns[s].cols() > 0 && (!delay || acts_on(*delay, design.segments()[s].channel));
    // A delay's own rate is second order.
    if (wanted && term.candidate->kind != CandidateKind::delay) {
      rates.push_back(
          term.columns.rates([&] { return design.columns(*term.candidate, term.nonlinear, 1); }));
      continue;
    }
    BandColumns none = term.columns.get();  // keeps the coefficient's place
    for (MatrixXd& part : none) part.setZero();
    rates.push_back(std::move(none));
  }
  return rates;
}

BandColumns prediction_rate(const Design& design, const Model& model,
                            const std::vector<SharedColumns>& rates, const VectorXd& coefficients,
                            const Candidate& delay) {
  std::vector<const BandColumns*> all;
  for (const SharedColumns& rate : rates) all.push_back(&rate.get());
  BandColumns result(design.segments().size());
  for (std::size_t s = 0; s < result.size(); ++s) {
    const int channel = design.segments()[s].channel;
    if (!acts_on(delay, channel)) continue;
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
