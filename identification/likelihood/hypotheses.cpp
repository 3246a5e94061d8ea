// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/hypotheses.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/starting_values.h"

namespace sinew::diagnosis {
namespace {

using Eigen::VectorXd;

double log_prior_of(const Candidate& source, bool named) {
  return std::log(kPriorOdds * (named ? 1.0 : kUnnamedOdds) *
                  (source.unlikely ? kUnlikelyOdds : 1.0));
}

/// Grid points of starting_values() that differ by one step of one parameter: the last parameter
/// varies fastest.
void link_neighbours(const Candidate& source, int first, std::vector<Shape>& shapes) {
  const auto count = static_cast<int>(shapes.size()) - first;
  int stride = 1;
  for (std::size_t k = source.nonlinear.size(); k-- > 0;) {
    const int points = std::max(1, source.nonlinear[k].grid);
    for (int i = 0; i < count; ++i)
      if ((i / stride) % points + 1 < points)
        shapes[static_cast<std::size_t>(first + i)].neighbours.push_back(first + i + stride);
    stride *= points;
  }
}

bool is_named(const Candidate& source) {
  return source.kind == CandidateKind::named || source.kind == CandidateKind::delay;
}

void add_hypothesis(int candidate, const Candidate& source, Hypotheses& all) {
  Hypothesis h;
  h.candidate = candidate;
  h.source = &source;
  h.named = is_named(source);
  h.log_prior = log_prior_of(source, h.named);
  h.body_within = source.body_within;
  h.is_law = !has_any_form(source, candidate < 0) && !source.is_value;
  all.list.push_back(std::move(h));
}

void add_grid(const Candidate& source, Hypotheses& all) {
  const auto hypothesis = static_cast<int>(all.list.size()) - 1;
  const auto first = static_cast<int>(all.shapes.size());
  for (const VectorXd& value : starting_values(source)) {
    all.list.back().shapes.push_back(static_cast<int>(all.shapes.size()));
    all.shapes.push_back({hypothesis, value, {}, {}});
  }
  // Tangent and secant together are a parabola.
  if (source.secant != 0.0)
    all.shapes[static_cast<std::size_t>(first)].neighbours.push_back(first + 1);
  // Splines are no points of a family that one could stand between.
  else if (source.nonlinear.size() > 0 && source.linear.size() == 1)
    link_neighbours(source, first, all.shapes);
}

/// Several forms of one cause at one place are one hypothesis' prior.
void share_priors(std::vector<Hypothesis>& list) {
  std::map<std::pair<std::string, std::string>, int> forms;
  for (const Hypothesis& h : list) ++forms[{h.source->name, h.source->place}];
  for (Hypothesis& h : list) h.log_prior -= std::log(forms[{h.source->name, h.source->place}]);
}

/// A delay's column is how much what the model says is moved by it, per second of the delay. For
/// one of nothing it is the rate, which a short delay stands for.
BandColumns moved_columns(const Design& design, const std::vector<VectorXd>& said,
                          const Candidate& delay, double by) {
  constexpr double shortest = 1e-4;  // s: one of less is as straight as its rate
  const bool is_rate = std::abs(by) < shortest;
  const double from = is_rate ? -shortest : 0.0, to = is_rate ? shortest : by;
  BandColumns columns(design.segments().size());
  for (std::size_t s = 0; s < columns.size(); ++s) {
    if (!acts_on(delay, design.segments()[s].channel)) continue;
    const auto i = static_cast<int>(s);
    columns[s] = (design.in_band(i, said[s], to) - design.in_band(i, said[s], from)) / (to - from);
  }
  return columns;
}

BandColumns columns_of(const Design& design, const Hypotheses& all, const Candidate& source,
                       const VectorXd& nonlinear) {
  return source.kind == CandidateKind::delay ? moved_columns(design, all.said, source, nonlinear(0))
                                             : design.columns(source, nonlinear);
}

}  // namespace

bool has_any_form(const Candidate& source, bool of_model) {
  return of_model || source.has_model_form || source.kind == CandidateKind::flexible ||
         std::any_of(source.linear.begin(), source.linear.end(),
                     [](const LinearParameter& p) { return p.share < 1.0; });
}

Hypotheses make_hypotheses(const Design& design, const Model& baseline) {
  const Problem& problem = design.problem();
  Hypotheses all;
  if (problem.deviations.empty())
    all.parts.base = baseline;
  else
    all.parts = take_apart(design, baseline);
  all.said = said_unfiltered(design, all.parts,
                             solve(stack(all.parts.base, even_weights(design))).coefficients);
  for (std::size_t i = 0; i < all.parts.deviations.size(); ++i) {
    const Term& term = all.parts.deviations[i];
    add_hypothesis(-1 - static_cast<int>(i), *term.candidate, all);
    all.list.back().log_prior += problem.deviations[i].unlikely ? std::log(kUnlikelyOdds) : 0.0;
    all.list.back().body_within = problem.deviations[i].body_within;
    all.list.back().shapes.push_back(static_cast<int>(all.shapes.size()));
    all.shapes.push_back({static_cast<int>(all.list.size()) - 1, VectorXd(), term.columns, {}});
  }
  for (std::size_t c = 0; c < problem.library.size(); ++c) {
    const Candidate& source = problem.library[c];
    if (source.nuisance) continue;
    add_hypothesis(static_cast<int>(c), source, all);
    add_grid(source, all);
  }
  share_priors(all.list);
  tbb::parallel_for(0, static_cast<int>(all.shapes.size()), [&](int i) {
    Shape& shape = all.shapes[static_cast<std::size_t>(i)];
    if (shape.columns.empty())
      shape.columns =
          columns_of(design, all, *all.list[static_cast<std::size_t>(shape.hypothesis)].source,
                     shape.nonlinear);
  });
  return all;
}

void add_shape(const Design& design, int hypothesis, const VectorXd& nonlinear, Hypotheses& all) {
  Hypothesis& h = all.list[static_cast<std::size_t>(hypothesis)];
  h.shapes.push_back(static_cast<int>(all.shapes.size()));
  all.shapes.push_back(
      {hypothesis, nonlinear, columns_of(design, all, *h.source, nonlinear), {}, 0.0});
}

Term term_of(const Hypotheses& all, int shape) {
  const Shape& s = all.shapes[static_cast<std::size_t>(shape)];
  const Hypothesis& h = all.list[static_cast<std::size_t>(s.hypothesis)];
  Term term;
  term.candidate = h.source;
  term.nonlinear = s.nonlinear;
  term.columns = s.columns;
  if (h.candidate < 0) term.deviation = -1 - h.candidate;
  return term;
}

}  // namespace sinew::diagnosis
