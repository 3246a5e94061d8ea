// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/parameter_deviations.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/diagnosis/best_form.h"
#include "identification/diagnosis/collinearity.h"
#include "identification/diagnosis/deviation_search.h"
#include "identification/diagnosis/deviation_terms.h"
#include "identification/diagnosis/verdict.h"
#include "identification/regression/held_bodies.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::VectorXd;

// Deviance that one more wrong value must be worth: one that explains as much as two is likelier.
constexpr double kAnother = 4.0;
// A model without friction lacks two values at every joint, and more may be wrong with it.
constexpr int kMostAtJoint = 6, kManyDeviations = 48;

/// What small changes of the causes' nonlinear parameters add, a term each; they have no candidate.
/// The parameters were fitted with every deviation free: what they can take up beside a deviation
/// at its nominal value is not the deviation's.
std::vector<Term> shape_changes(const Design& design, const Model& model, const Weights& weights) {
  std::vector<Term> changes;
  const VectorXd coefficients = solve(stack(model, weights)).coefficients;
  const std::vector<Index> first = first_columns(model);
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const Term& term = model.terms[t];
    if (term.baseline || !has_free_shape(term)) continue;
    const VectorXd own = coefficients.segment(first[t], first[t + 1] - first[t]);
    for (Index p = 0; p < term.nonlinear.size(); ++p) {
      if (!is_free(term.candidate->nonlinear[static_cast<std::size_t>(p)])) continue;
      changes.emplace_back();
      changes.back().columns = shape_rate(design, term, p, own);
    }
  }
  return changes;
}

/// A segment's whitened rows: columns of the model's free part, and of the deviations. A model of
/// many joints has too many rows and columns for all of them at once.
struct Rows {
  MatrixXd base, deviations;
  VectorXd y;
};

/// `own`: coefficients of the free part, which come first.
Rows rows_of(const Stack& stack, std::size_t segment, Index own) {
  const MatrixXd& a = stack.a[segment];
  Rows rows{MatrixXd::Zero(a.rows(), own), MatrixXd::Zero(a.rows(), stack.coefficients - own),
            stack.y.segment(stack.first_row[segment], a.rows())};
  for (std::size_t c = 0; c < stack.at[segment].size(); ++c) {
    const Index at = stack.at[segment][c];
    (at < own ? rows.base.col(at) : rows.deviations.col(at - own)) = a.col(static_cast<Index>(c));
  }
  return rows;
}

/// A prior is one more row: what was known is 0, weighed by the inverse of its spread.
Rows prior_rows(const Stack& stack, Index own) {
  std::vector<Index> known;
  for (Index c = 0; c < stack.prior.size(); ++c)
    if (stack.prior(c) > 0.0) known.push_back(c);
  const auto count = static_cast<Index>(known.size());
  MatrixXd rows = MatrixXd::Zero(count, stack.coefficients);
  for (Index i = 0; i < count; ++i) {
    const Index at = known[static_cast<std::size_t>(i)];
    rows(i, at) = std::sqrt(stack.prior(at));
  }
  return {rows.leftCols(own), rows.rightCols(stack.coefficients - own), VectorXd::Zero(count)};
}

/// What the free part takes of the deviations' columns and of the target.
struct Taken {
  MatrixXd of_columns;
  VectorXd of_target;
};

Taken taken_by_base(const Stack& stack, Index own) {
  MatrixXd base = MatrixXd::Zero(own, own), cross = MatrixXd::Zero(own, stack.coefficients - own);
  VectorXd target = VectorXd::Zero(own);
  const auto add = [&](const Rows& rows) {
    base.selfadjointView<Eigen::Lower>().rankUpdate(rows.base.transpose());
    cross += rows.base.transpose() * rows.deviations;
    target += rows.base.transpose() * rows.y;
  };
  for (std::size_t s = 0; s < stack.a.size(); ++s)
    if (stack.a[s].rows() > 0) add(rows_of(stack, s, own));
  add(prior_rows(stack, own));
  const MatrixXd inverse = scaled_pseudo_inverse(MatrixXd(base.selfadjointView<Eigen::Lower>()));
  return {inverse * cross, inverse * target};
}

/// Products of the rows with the free part projected out.
void add_products(Rows rows, const Taken& taken, const MatrixXf* draws, DeviationMoments& m) {
  MatrixXd& x = rows.deviations;
  if (rows.base.cols() > 0) {
    x -= rows.base * taken.of_columns;
    m.base += (rows.y - rows.base * taken.of_target).squaredNorm();
  } else {
    m.base += rows.y.squaredNorm();
  }
  m.gram.selfadjointView<Eigen::Lower>().rankUpdate(x.transpose());
  m.target += x.transpose() * rows.y;
  if (!draws || draws->cols() == 0) return;
  if (m.surrogates.size() == 0) m.surrogates = MatrixXd::Zero(x.cols(), draws->cols());
  m.surrogates += (x.cast<float>().transpose() * *draws).cast<double>();
}

DeviationMoments moments(const Design& design, const DeviationTerms& parts,
                         const std::vector<Term>& shapes, const NoiseView& noise) {
  Model all = parts.base;
  all.terms.insert(all.terms.end(), shapes.begin(), shapes.end());
  const Index own = first_columns(all).back();
  for (const Term& deviation : parts.deviations) all.terms.push_back(deviation);
  // A deviation without columns in these logs still has its places.
  DeviationMoments m;
  m.first.push_back(0);
  for (const Term& deviation : parts.deviations) {
    Index wide = 0;
    for (const MatrixXd& x : deviation.columns) wide = std::max(wide, x.cols());
    m.first.push_back(m.first.back() + wide);
  }
  const Stack s = stack(all, noise.weights);
  const Index wide = s.coefficients - own;
  m.gram = MatrixXd::Zero(wide, wide);
  m.target = VectorXd::Zero(wide);
  const Taken taken = taken_by_base(s, own);
  for (std::size_t i = 0; i < s.a.size(); ++i)
    if (s.a[i].rows() > 0)
      add_products(rows_of(s, i, own), taken,
                   i < noise.surrogates.size() ? &noise.surrogates[i] : nullptr, m);
  add_products(prior_rows(s, own), taken, nullptr, m);
  m.gram.triangularView<Eigen::StrictlyUpper>() = m.gram.transpose();
  for (const ParameterDeviation& deviation : design.problem().deviations)
    m.body_within.push_back(deviation.body_within);
  m.low = VectorXd::Zero(wide);
  m.high = VectorXd::Zero(wide);
  for (std::size_t l = 0; l < parts.deviations.size(); ++l)
    for (Index c = m.first[l]; c < m.first[l + 1]; ++c) {
      const DeviationParameter& p =
          design.problem().deviations[l].parameters[static_cast<std::size_t>(c - m.first[l])];
      m.low(c) = p.low;
      m.high(c) = p.high;
    }
  return m;
}

/// The causes' nonlinear parameters fitted beside the set. Those of the baseline stay: the levels'
/// columns are made with them.
Model model_of(const Design& design, const Weights& weights, const DeviationTerms& parts,
               const DeviationSearch& search, const DeviationSet& set) {
  Model model = parts.base;
  bool open = false, held = false;
  for (const Term& term : model.terms) (term.baseline ? held : open) |= has_free_shape(term);
  for (const int deviation : set) {
    model.terms.push_back(parts.deviations[static_cast<std::size_t>(deviation)]);
    model.terms.back().freedom = search.freedom(deviation);
  }
  if (open && !held) refine(design, weights, RefineScope::all_terms, model);
  return model;
}

/// The causes' shapes were fitted with every deviation free.
Model given_deviations(const Design& design, const Weights& weights, const Model& model) {
  return best_form(design, weights, model, [](const Term&) { return true; });
}

double held_out_drop(const Design& design, const Settings& settings, const Model& before,
                     const Model& after, const Weights& weights) {
  const double a =
      held_out(design, before, solve(stack(before, weights)), settings.blocks).plain.sum();
  const double b =
      held_out(design, after, solve(stack(after, weights)), settings.blocks).plain.sum();
  return a - b;
}

/// What one named deviation rests on, and why it does not hold (empty: it does).
struct Judged {
  Evidence evidence;
  std::string against;
};

/// A set of deviations, its model and what that loses on left-out blocks; both once more with
/// bodies held (held_bodies.h).
struct FittedSet {
  DeviationSet set;
  Model model, held;
  BlockLosses losses, held_losses;
};

FittedSet fit_set(const Design& design, const Settings& settings, const Weights& weights,
                  const DeviationSet& set, Model model) {
  FittedSet all;
  all.set = set;
  all.held = hold_bodies(design, model, weights);
  all.losses = all.held_losses = cross_validate(design, model, weights, settings.blocks);
  if (all.held.terms.size() < model.terms.size())
    all.held_losses = cross_validate(design, all.held, weights, settings.blocks);
  all.model = std::move(model);
  return all;
}

Model without_deviation(Model model, int deviation) {
  std::erase_if(model.terms, [&](const Term& t) { return t.deviation == deviation; });
  return model;
}

/// Much of what the model's own values leave over, or plainly much of what is left beside all
/// others: large friction must not hide a rotor that is plain once the friction is known.
bool is_worth_naming(const Evidence& evidence, const Settings& settings) {
  constexpr double kMuchOfTheRest = 0.1;
  return evidence.validated > 0.0 && evidence.gain.share >= settings.least_share &&
         (evidence.of_baseline >= settings.least_of_baseline || evidence.gain.low > kMuchOfTheRest);
}

Judged judge_deviation(const Design& design, const Settings& settings, const DeviationTerms& parts,
                       const DeviationMoments& m, const DeviationSearch& search,
                       const Weights& weights, const FittedSet& all, int deviation,
                       const VectorXd& nominal_loss) {
  Judged j;
  const DeviationSet others = without(all.set, deviation);
  j.evidence.statistic = drop(m, all.set) - std::max(0.0, drop(m, others));
  j.evidence.freedom = search.freedom(deviation);
  j.evidence.p_family = p_value(m, all.set, deviation, j.evidence.statistic);
  const Model before =
      given_deviations(design, weights, model_of(design, weights, parts, search, others));
  const bool held = all.held.terms.size() < all.model.terms.size() &&
                    !is_of_body(parts.deviations[static_cast<std::size_t>(deviation)]);
  const Model without_it =
      held ? given_deviations(design, weights, without_deviation(all.held, deviation)) : before;
  const BlockLosses b = cross_validate(design, without_it, weights, settings.blocks);
  const BlockLosses& a = held ? all.held_losses : all.losses;
  j.evidence.validated = b.whitened.sum() - a.whitened.sum();
  const VectorXd channels =
      channels_of(design, parts.deviations[static_cast<std::size_t>(deviation)]);
  const VectorXd losses_before = b.plain * channels, losses_after = a.plain * channels;
  j.evidence.gain = block_bootstrap_gain(losses_before, losses_after, 0.95, settings.seed);
  j.evidence.of_baseline = (losses_before - losses_after).sum() / nominal_loss.dot(channels);
  const double worth = parameter_price(design) * j.evidence.freedom + kAnother;
  if (j.evidence.p_family > settings.significance)
    j.against = "too little to be told from noise";
  else if (deviance(before, weights) - deviance(all.model, weights) < worth)
    j.against = "another form of the named causes says as much";
  else if (!is_worth_naming(j.evidence, settings))
    j.against = "no gain worth naming on left-out blocks";
  // What is plain here and nowhere there is for the verdict: the logs disagree.
  else if (!design.problem().holdout.empty() && !is_plain(j.evidence.gain, j.evidence.p_family) &&
           held_out_drop(design, settings, without_it, held ? all.held : all.model, weights) <= 0.0)
    j.against = "no gain on the held-out logs";
  return j;
}

/// The same cause is in the model already, beside the baseline, or part of one.
bool is_named(const ParameterDeviation& deviation, const Model& model) {
  return std::any_of(model.terms.begin(), model.terms.end(), [&](const Term& term) {
    return !term.baseline && term.candidate->place == deviation.place &&
           (term.candidate->name == deviation.name || term.candidate->contains == deviation.name);
  });
}

/// What the deviations outside the set would add to it.
void judge_others(const DeviationMoments& m, const DeviationSet& set, DeviationSelection& result) {
  for (int l = 0; l + 1 < static_cast<int>(m.first.size()); ++l) {
    DeviationSet more = set;
    if (std::count(set.begin(), set.end(), l)) more = without(set, l);
    const double few = drop(m, more);
    more.push_back(l);
    const double statistic = std::max(0.0, drop(m, more) - few);
    result.statistic.push_back(statistic);
    result.p_family.push_back(statistic > 0.0 ? p_value(m, more, l, statistic) : 1.0);
  }
}

}  // namespace

DeviationSelection select_deviations(const Design& design, const Settings& settings,
                                     const Selection& selection,
                                     const std::vector<int>& withdrawn) {
  const DeviationTerms parts = take_apart(design, selection.model);
  DeviationSelection result{selection, {}, {}, {}};
  Selection& state = result.state;
  draw_surrogates(design, settings, state.noise);
  const Weights& weights = state.noise.weights;
  const std::vector<Term> shapes = shape_changes(design, selection.model, weights);
  const DeviationMoments m = moments(design, parts, shapes, state.noise);
  const int channels = design.problem().channels;
  const int most = std::max(
      {settings.most_deviations, channels, std::min(kMostAtJoint * channels, kManyDeviations)});
  const DeviationSearch search(m, {parameter_price(design), kAnother}, most);
  const VectorXd nominal_loss = cross_validate(design, parts.base, weights, settings.blocks)
                                    .plain.colwise()
                                    .sum()
                                    .transpose();
  std::vector<bool> banned(parts.deviations.size(), false);
  for (std::size_t l = 0; l < banned.size(); ++l) {
    const Index own = m.first[l];
    // A payload at the axis has a first moment alone.
    banned[l] = !(m.gram.diagonal().segment(own, m.first[l + 1] - own).array() > 0.0).any();
    if (banned[l])
      result.refused.push_back({-1 - static_cast<int>(l), "not excited by these logs"});
  }
  for (std::size_t l = 0; l < banned.size(); ++l)
    banned[l] = banned[l] || is_named(design.problem().deviations[l], selection.model);
  for (const int deviation : withdrawn) {
    banned[static_cast<std::size_t>(deviation)] = true;
    result.refused.push_back(
        {-1 - deviation, "not told from chance or from structure without a name"});
  }
  DeviationSet set;
  std::vector<Evidence> evidence;
  for (bool settled = false; !settled;) {
    set = search.best(banned);
    evidence.clear();
    settled = true;
    double weakest = std::numeric_limits<double>::infinity();
    Refusal refusal;
    const FittedSet all =
        fit_set(design, settings, weights, set,
                given_deviations(design, weights, model_of(design, weights, parts, search, set)));
    std::vector<Judged> judged(set.size());
    tbb::parallel_for(0, static_cast<int>(set.size()), [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      judged[k] =
          judge_deviation(design, settings, parts, m, search, weights, all, set[k], nominal_loss);
    });
    for (std::size_t i = 0; i < set.size(); ++i) {
      const int deviation = set[i];
      const Judged& j = judged[i];
      evidence.push_back(j.evidence);
      if (j.against.empty() || j.evidence.statistic >= weakest) continue;
      weakest = j.evidence.statistic;
      refusal = {-1 - deviation, j.against};
      settled = false;
    }
    if (const auto deviation = settled ? cancelled(m, set) : std::nullopt) {
      settled = false;
      refusal = {-1 - *deviation, "it would undo what others of the causes do"};
    }
    if (settled) {
      const auto collinear =
          find_collinear_term(design, settings, weights, all.model, CollinearAmong::deviations);
      if (!collinear) break;
      settled = false;
      refusal = {-1 - all.model.terms[*collinear].deviation,
                 "no more than what the form of a named cause leaves over"};
    }
    banned[static_cast<std::size_t>(-1 - refusal.candidate)] = true;
    result.refused.push_back(refusal);
  }
  judge_others(m, set, result);
  state.model = given_deviations(design, weights, model_of(design, weights, parts, search, set));
  state.deviations = parts.deviations;
  for (Term& deviation : state.deviations) deviation.freedom = search.freedom(deviation.deviation);
  state.made = parts.made;
  state.evidence.assign(state.model.terms.size() - set.size(), {});
  state.evidence.insert(state.evidence.end(), evidence.begin(), evidence.end());
  return result;
}

}  // namespace sinew::diagnosis
