// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/linear_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/regression/body_limits.h"
#include "identification/regression/inner_loop.h"
#include "identification/regression/pseudo_inverse.h"

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

/// What every coefficient's column, and its prior, says of the residual.
VectorXd moment_of(const Stack& stack, const LinearFit& fit) {
  std::vector<VectorXd> own(stack.a.size());
  inner_loop(own.size(), [&](std::size_t s) {
    own[s] = stack.a[s].transpose() * fit.residual.segment(stack.first_row[s], stack.a[s].rows());
  });
  VectorXd moment = -stack.prior.cwiseProduct(fit.coefficients);
  for (std::size_t s = 0; s < own.size(); ++s)
    if (!stack.at[s].empty()) moment(stack.at[s]) += own[s];
  return moment;
}

}  // namespace

LinearFit refined_fit(const Stack& stack, const std::function<VectorXd(const VectorXd&)>& inverse) {
  LinearFit fit;
  fit.residual = stack.y;
  fit.coefficients = VectorXd::Zero(stack.coefficients);
  for (int round = 0; round < 2 && stack.coefficients > 0; ++round) {
    const VectorXd step = inverse(moment_of(stack, fit));
    fit.coefficients += step;
    inner_loop(stack.a.size(), [&](std::size_t s) {
      if (!stack.at[s].empty())
        fit.residual.segment(stack.first_row[s], stack.a[s].rows()) -=
            stack.a[s] * step(stack.at[s]);
    });
  }
  fit.deviance = fit.residual.squaredNorm() + stack.prior.dot(fit.coefficients.cwiseAbs2());
  return fit;
}

LinearFit solve(const Stack& stack) {
  const MatrixXd covariance = scaled_pseudo_inverse(stack.gram());
  LinearFit fit =
      refined_fit(stack, [&](const VectorXd& moment) { return VectorXd(covariance * moment); });
  fit.covariance = covariance;
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
