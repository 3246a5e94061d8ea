// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/refine.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "identification/regression/projected_residual.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// One nonlinear parameter in the coordinates of the search (logarithm where it is a scale).
struct Coordinate {
  std::size_t term = 0;
  Index parameter = 0;
  bool logarithmic = false;
  double low = 0.0, high = 0.0;
  double to_value(double u) const { return logarithmic ? std::exp(u) : u; }
  double from_value(double v) const { return logarithmic ? std::log(v) : v; }
};

std::vector<Coordinate> coordinates(const Model& model) {
  std::vector<Coordinate> list;
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const Candidate& candidate = *model.terms[t].candidate;
    if (candidate.kind == CandidateKind::delay) continue;
    for (std::size_t p = 0; p < candidate.nonlinear.size(); ++p) {
      const NonlinearParameter& range = candidate.nonlinear[p];
      Coordinate c{t, static_cast<Index>(p), range.logarithmic, 0.0, 0.0};
      c.low = c.from_value(range.low);
      c.high = c.from_value(range.high);
      if (c.high > c.low) list.push_back(c);
    }
  }
  return list;
}

/// A model's residual as a function of the coordinates.
class ResidualAt {
 public:
  ResidualAt(const Design& design, const Weights& weights, const Model& model,
             std::vector<Coordinate> coordinates)
      : coordinates_(std::move(coordinates)),
        residual_(design, weights, model, moving(model, coordinates_)) {
    for (const Term& term : model.terms) nonlinear_.push_back(term.nonlinear);
  }

  bool operator()(double const* const* blocks, double* residual) const {
    std::vector<VectorXd> wanted = nonlinear_;
    for (std::size_t c = 0; c < coordinates_.size(); ++c)
      wanted[coordinates_[c].term](coordinates_[c].parameter) =
          coordinates_[c].to_value(blocks[0][c]);
    const VectorXd left = residual_(wanted);
    if (!left.allFinite()) return false;
    VectorXd::Map(residual, left.size()) = left;
    return true;
  }

  Index rows() const { return residual_.rows(); }

 private:
  static std::vector<bool> moving(const Model& model, const std::vector<Coordinate>& list) {
    std::vector<bool> terms(model.terms.size(), false);
    for (const Coordinate& c : list) terms[c.term] = true;
    return terms;
  }

  std::vector<Coordinate> coordinates_;
  std::vector<VectorXd> nonlinear_;
  mutable ProjectedResidual residual_;  // remembers columns
};

void fit_nonlinear(const Design& design, const Weights& weights, Model& model) {
  const std::vector<Coordinate> list = coordinates(model);
  if (list.empty()) return;
  std::vector<double> u;
  for (const Coordinate& c : list)
    u.push_back(
        std::clamp(c.from_value(model.terms[c.term].nonlinear(c.parameter)), c.low, c.high));
  auto residual = std::make_unique<ResidualAt>(design, weights, model, list);
  const Index rows = residual->rows();
  ceres::NumericDiffOptions steps;
  steps.relative_step_size = 3e-3;  // columns with a kink are smooth on this scale only
  auto cost = std::make_unique<ceres::DynamicNumericDiffCostFunction<ResidualAt, ceres::CENTRAL>>(
      residual.release(), ceres::TAKE_OWNERSHIP, steps);
  cost->AddParameterBlock(static_cast<int>(u.size()));
  cost->SetNumResiduals(static_cast<int>(rows));
  ceres::Problem problem;
  problem.AddResidualBlock(cost.release(), nullptr, u.data());
  for (std::size_t c = 0; c < list.size(); ++c) {
    problem.SetParameterLowerBound(u.data(), static_cast<int>(c), list[c].low);
    problem.SetParameterUpperBound(u.data(), static_cast<int>(c), list[c].high);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 12;
  options.function_tolerance = 1e-5;
  // Ceres searches along every step where there are bounds; a step that does not help is tried
  // shorter anyhow.
  options.max_num_line_search_step_size_iterations = 0;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  std::vector<VectorXd> before;
  for (const Term& term : model.terms) before.push_back(term.nonlinear);
  for (std::size_t c = 0; c < list.size(); ++c)
    model.terms[list[c].term].nonlinear(list[c].parameter) = list[c].to_value(u[c]);
  for (std::size_t t = 0; t < before.size(); ++t)
    if (Term& term = model.terms[t]; term.nonlinear != before[t])
      term.columns = design.columns(*term.candidate, term.nonlinear);
}

/// Terms that share no segment with the others' are fitted by themselves: the component of terms,
/// by index, that hangs together with term `from`.
std::vector<std::size_t> component(const Model& model, std::size_t from) {
  std::vector<bool> segment(model.target.size(), false), in(model.terms.size(), false);
  const auto acts = [&](std::size_t t, std::size_t s) {
    return model.terms[t].columns[s].cols() > 0;
  };
  in[from] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t t = 0; t < in.size(); ++t)
      for (std::size_t s = 0; s < segment.size(); ++s) {
        if (!acts(t, s) || in[t] == segment[s]) continue;
        grown = true;
        in[t] = segment[s] = true;
      }
  }
  std::vector<std::size_t> list;
  for (std::size_t t = 0; t < in.size(); ++t)
    if (in[t]) list.push_back(t);
  return list;
}

void fit_by_components(const Design& design, const Weights& weights, Model& model) {
  std::vector<bool> done(model.terms.size(), false);
  for (std::size_t t = 0; t < done.size(); ++t) {
    if (done[t]) continue;
    const std::vector<std::size_t> terms = component(model, t);
    Model part;
    part.advance = model.advance;
    part.target = model.target;
    Weights own(weights.size());
    for (const std::size_t i : terms) {
      done[i] = true;
      part.terms.push_back(model.terms[i]);
      for (std::size_t s = 0; s < own.size(); ++s)
        if (model.terms[i].columns[s].cols() > 0) own[s] = weights[s];
    }
    fit_nonlinear(design, own, part);
    for (std::size_t i = 0; i < terms.size(); ++i) model.terms[terms[i]] = std::move(part.terms[i]);
  }
}

/// One Gauss-Newton step of every delay; returns the largest change [s].
double move_delays(const Design& design, const Weights& weights, Model& model) {
  double largest = 0.0;
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const Candidate& candidate = *model.terms[t].candidate;
    if (candidate.kind != CandidateKind::delay) continue;
    const VectorXd before = solve(stack(model, weights)).coefficients;
    VectorXd plain = before;
    plain(first_columns(model)[t]) = 0.0;
    model.terms[t].columns =
        prediction_rate(design, model, term_rates(design, model, &candidate), plain, candidate);
    const double step = solve(stack(model, weights)).coefficients(first_columns(model)[t]);
    const NonlinearParameter& range = candidate.nonlinear.front();
    const double old = model.terms[t].nonlinear(0);
    const double now = std::clamp(old + step, range.low, range.high);
    model.terms[t].nonlinear(0) = now;
    for (std::size_t s = 0; s < model.advance.size(); ++s)
      if (model.terms[t].columns[s].cols() > 0)
        set_advance(design, s, model.advance[s] - (now - old), model);
    largest = std::max(largest, std::abs(now - old));
  }
  return largest;
}

/// Makes every secant one to the coefficient that was fitted with it; returns the largest change
/// that still matters.
double move_secants(const Design& design, const Weights& weights, Model& model) {
  constexpr double kTangentHolds = 0.01;  // rad, or 1
  double largest = 0.0;
  const std::vector<Index> first = first_columns(model);
  VectorXd fitted;
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    Term& term = model.terms[t];
    if (term.candidate->secant == 0.0 || term.deviation >= 0) continue;
    if (fitted.size() == 0) fitted = solve(stack(model, weights)).coefficients;
    const LinearParameter& range = term.candidate->linear.front();
    const double now = std::clamp(fitted(first[t]), range.low, range.high);
    const double old = term.nonlinear.size() > 0 ? term.nonlinear(0) : 0.0;
    if (std::abs(now) < kTangentHolds || std::abs(now - old) < 0.01 * std::abs(now)) continue;
    term.nonlinear = VectorXd::Constant(1, now);
    term.columns = design.columns(*term.candidate, term.nonlinear);
    largest = std::max(largest, std::abs(now - old));
  }
  return largest;
}

}  // namespace

void refine(const Design& design, const Weights& weights, Model& model) {
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    fit_by_components(design, weights, model);
    const double moved = move_secants(design, weights, model);
    if (move_delays(design, weights, model) < 2e-6 && moved == 0.0) break;
  }
}

Term make_term(const Design& design, const Candidate& candidate, const VectorXd& nonlinear,
               bool baseline) {
  return {&candidate, baseline, nonlinear, design.columns(candidate, nonlinear)};
}

BandColumns shape_rate(const Design& design, const Term& term, Index parameter,
                       const VectorXd& coefficients) {
  const NonlinearParameter& range = term.candidate->nonlinear[static_cast<std::size_t>(parameter)];
  const double h = 1e-3 * (range.logarithmic ? term.nonlinear(parameter) : range.high - range.low);
  VectorXd up = term.nonlinear, down = term.nonlinear;
  up(parameter) += h;
  down(parameter) -= h;
  std::vector<bool> training;
  for (const Segment& s : design.segments()) training.push_back(!s.holdout);
  BandColumns rate = design.columns_at(training, *term.candidate, up);
  const BandColumns low = design.columns_at(training, *term.candidate, down);
  for (std::size_t s = 0; s < rate.size(); ++s)
    if (rate[s].cols() > 0) rate[s] = (rate[s] - low[s]) * coefficients / (2.0 * h);
  return rate;
}

void append_term(const Design& design, const Weights& weights, const Candidate& candidate,
                 const VectorXd& nonlinear, Model& model) {
  if (candidate.kind != CandidateKind::delay) {
    model.terms.push_back(make_term(design, candidate, nonlinear, false));
    return;
  }
  const NonlinearParameter& range = candidate.nonlinear.front();
  const double delay = std::clamp(nonlinear(0), range.low, range.high);
  const VectorXd coefficients = solve(stack(model, weights)).coefficients;
  model.terms.push_back({&candidate, false, VectorXd::Constant(1, delay),
                         prediction_rate(design, model, term_rates(design, model, &candidate),
                                         coefficients, candidate)});
  for (std::size_t s = 0; delay != 0.0 && s < model.advance.size(); ++s)
    if (model.terms.back().columns[s].cols() > 0)
      set_advance(design, s, model.advance[s] - delay, model);
}

void remove_term(const Design& design, std::size_t index, Model& model) {
  const Term term = model.terms[index];
  if (term.candidate->kind == CandidateKind::delay)
    for (std::size_t s = 0; s < design.segments().size(); ++s)
      if (term.columns[s].cols() > 0)
        set_advance(design, s, model.advance[s] + term.nonlinear(0), model);
  model.terms.erase(model.terms.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace sinew::diagnosis
