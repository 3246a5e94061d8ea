// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/levels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/diagnosis/best_form.h"
#include "identification/diagnosis/level_search.h"
#include "identification/diagnosis/level_terms.h"
#include "identification/logs/parallel_for.h"
#include "identification/regression/refine.h"
#include "identification/diagnosis/shadow.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::VectorXd;

// Deviance that one more wrong value must be worth: one that explains as much as two is likelier.
constexpr double kAnother = 4.0;
// A model without friction lacks two values at every joint, and more may be wrong with it.
constexpr int kManyLevels = 24;

/// What small changes of the causes' nonlinear parameters add, a term each; they have no candidate.
/// The parameters were fitted with every level free: what they can take up beside a level at its
/// nominal value is not the level's.
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

LevelMoments moments(const Design& design, const LevelTerms& parts, const std::vector<Term>& shapes,
                     const NoiseView& noise) {
  Model all = parts.base;
  all.terms.insert(all.terms.end(), shapes.begin(), shapes.end());
  const Index own = first_columns(all).back();
  for (const Term& level : parts.levels) all.terms.push_back(level);
  // A level without columns in these logs still has its places.
  LevelMoments m;
  m.first.push_back(0);
  for (const Term& level : parts.levels) {
    Index wide = 0;
    for (const MatrixXd& x : level.columns) wide = std::max(wide, x.cols());
    m.first.push_back(m.first.back() + wide);
  }
  const Stack s = stack(all, noise.weights);
  const MatrixXd dense = s.dense();
  const MatrixXd x0 = dense.leftCols(own);
  MatrixXd x = dense.rightCols(dense.cols() - own);
  if (own > 0) {
    const MatrixXd inverse = scaled_pseudo_inverse(x0.transpose() * x0);
    x -= x0 * (inverse * (x0.transpose() * x));
    m.base = (s.y - x0 * (inverse * (x0.transpose() * s.y))).squaredNorm();
  } else {
    m.base = s.y.squaredNorm();
  }
  m.gram = x.transpose() * x;
  m.target = x.transpose() * s.y;
  for (std::size_t i = 0; i < noise.surrogates.size(); ++i) {
    const MatrixXf& draws = noise.surrogates[i];
    if (draws.cols() == 0) continue;
    if (m.surrogates.size() == 0) m.surrogates = MatrixXd::Zero(x.cols(), draws.cols());
    const MatrixXf part = x.middleRows(s.first_row[i], draws.rows()).cast<float>();
    m.surrogates += (part.transpose() * draws).cast<double>();
  }
  for (const LevelCause& level : design.problem().levels) {
    m.dearer.push_back(level.unlikely ? kUnlikely : kAnother);
    m.body_within.push_back(level.body_within);
  }
  m.low = VectorXd::Zero(x.cols());
  m.high = VectorXd::Zero(x.cols());
  for (std::size_t l = 0; l < parts.levels.size(); ++l)
    for (Index c = m.first[l]; c < m.first[l + 1]; ++c) {
      const LevelParameter& p =
          design.problem().levels[l].parameters[static_cast<std::size_t>(c - m.first[l])];
      m.low(c) = p.low;
      m.high(c) = p.high;
    }
  return m;
}

/// The causes' nonlinear parameters fitted beside the set. Those of the baseline stay: the levels'
/// columns are made with them.
Model model_of(const Design& design, const Weights& weights, const LevelTerms& parts,
               const LevelSearch& search, const LevelSet& set) {
  Model model = parts.base;
  bool open = false, held = false;
  for (const Term& term : model.terms) (term.baseline ? held : open) |= has_free_shape(term);
  for (const int level : set) {
    model.terms.push_back(parts.levels[static_cast<std::size_t>(level)]);
    model.terms.back().freedom = search.freedom(level);
  }
  if (open && !held) refine(design, weights, RefineScope::all_terms, model);
  return model;
}

/// The causes' shapes were fitted with every level free.
Model beside_levels(const Design& design, const Weights& weights, const Model& model) {
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

/// What one named level rests on, and why it does not hold (empty: it does).
struct Judged {
  Evidence evidence;
  std::string against;
};

/// A set of levels, its model and what that loses on left-out blocks.
struct FittedSet {
  LevelSet set;
  Model model;
  BlockLosses losses;
};

/// Much of what the model's own values leave over, or most of what is left beside all others: large
/// friction must not hide a part of it that is plain once the rest is known.
bool is_worth_naming(const Evidence& evidence, const Settings& settings) {
  constexpr double kMostOfTheRest = 0.5;
  return evidence.validated > 0.0 && evidence.gain.share >= settings.least_share &&
         (evidence.of_baseline >= settings.least_of_baseline || evidence.gain.low > kMostOfTheRest);
}

Judged judge_level(const Design& design, const Settings& settings, const LevelTerms& parts,
                   const LevelMoments& m, const LevelSearch& search, const Weights& weights,
                   const FittedSet& all, int level, const VectorXd& nominal_loss) {
  Judged j;
  const LevelSet others = without(all.set, level);
  j.evidence.statistic = drop(m, all.set) - std::max(0.0, drop(m, others));
  j.evidence.freedom = search.freedom(level);
  j.evidence.p_family = p_value(m, all.set, level, j.evidence.statistic);
  const Model before =
      beside_levels(design, weights, model_of(design, weights, parts, search, others));
  const BlockLosses b = cross_validate(design, before, weights, settings.blocks);
  j.evidence.validated = b.whitened.sum() - all.losses.whitened.sum();
  const VectorXd channels = channels_of(design, parts.levels[static_cast<std::size_t>(level)]);
  const VectorXd losses_before = b.plain * channels, losses_after = all.losses.plain * channels;
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
           held_out_drop(design, settings, before, all.model, weights) <= 0.0)
    j.against = "no gain on the held-out logs";
  return j;
}

/// The same cause is in the model already, beside the baseline, or part of one.
bool is_named(const LevelCause& level, const Model& model) {
  return std::any_of(model.terms.begin(), model.terms.end(), [&](const Term& term) {
    return !term.baseline && term.candidate->place == level.place &&
           (term.candidate->name == level.name || term.candidate->contains == level.name);
  });
}

/// What the levels outside the set would add to it.
void judge_others(const LevelMoments& m, const LevelSet& set, LevelSelection& result) {
  for (int l = 0; l + 1 < static_cast<int>(m.first.size()); ++l) {
    LevelSet more = set;
    if (std::count(set.begin(), set.end(), l)) more = without(set, l);
    const double few = drop(m, more);
    more.push_back(l);
    const double statistic = std::max(0.0, drop(m, more) - few);
    result.statistic.push_back(statistic);
    result.p_family.push_back(statistic > 0.0 ? p_value(m, more, l, statistic) : 1.0);
  }
}

}  // namespace

LevelSelection restrict_to_levels(const Design& design, const Settings& settings,
                                  const Selection& selection, const std::vector<int>& withdrawn) {
  const LevelTerms parts = take_apart(design, selection.model);
  LevelSelection result{selection, {}, {}, {}};
  Selection& state = result.state;
  draw_surrogates(design, settings, state.noise);
  const Weights& weights = state.noise.weights;
  const std::vector<Term> shapes = shape_changes(design, selection.model, weights);
  const LevelMoments m = moments(design, parts, shapes, state.noise);
  const int channels = design.problem().channels;
  const int most = std::max({settings.most_levels, channels, std::min(3 * channels, kManyLevels)});
  const LevelSearch search(m, parameter_price(design), most, settings.threads);
  const VectorXd nominal_loss = cross_validate(design, parts.base, weights, settings.blocks)
                                    .plain.colwise()
                                    .sum()
                                    .transpose();
  std::vector<bool> banned(parts.levels.size(), false);
  for (std::size_t l = 0; l < banned.size(); ++l) {
    const Index own = m.first[l];
    // A payload at the axis has a first moment alone.
    banned[l] = !(m.gram.diagonal().segment(own, m.first[l + 1] - own).array() > 0.0).any();
    if (banned[l])
      result.refused.push_back({-1 - static_cast<int>(l), "not excited by these logs"});
  }
  for (std::size_t l = 0; l < banned.size(); ++l)
    banned[l] = banned[l] || is_named(design.problem().levels[l], selection.model);
  for (const int level : withdrawn) {
    banned[static_cast<std::size_t>(level)] = true;
    result.refused.push_back({-1 - level, "not told from chance or from structure without a name"});
  }
  LevelSet set;
  std::vector<Evidence> evidence;
  for (bool settled = false; !settled;) {
    set = search.best(banned);
    evidence.clear();
    settled = true;
    double weakest = std::numeric_limits<double>::infinity();
    Refusal refusal;
    FittedSet all{
        set, beside_levels(design, weights, model_of(design, weights, parts, search, set)), {}};
    all.losses = cross_validate(design, all.model, weights, settings.blocks);
    std::vector<Judged> judged(set.size());
    parallel_for(static_cast<int>(set.size()), settings.threads, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      judged[k] =
          judge_level(design, settings, parts, m, search, weights, all, set[k], nominal_loss);
    });
    for (std::size_t i = 0; i < set.size(); ++i) {
      const int level = set[i];
      const Judged& j = judged[i];
      evidence.push_back(j.evidence);
      if (j.against.empty() || j.evidence.statistic >= weakest) continue;
      weakest = j.evidence.statistic;
      refusal = {-1 - level, j.against};
      settled = false;
    }
    if (const auto level = settled ? cancelled(m, set) : std::nullopt) {
      settled = false;
      refusal = {-1 - *level, "it would undo what others of the causes do"};
    }
    if (settled) {
      const auto shadow = find_shadow(design, settings, weights, all.model, ShadowOf::levels);
      if (!shadow) break;
      settled = false;
      refusal = {-1 - all.model.terms[*shadow].level,
                 "no more than what the form of a named cause leaves over"};
    }
    banned[static_cast<std::size_t>(-1 - refusal.candidate)] = true;
    result.refused.push_back(refusal);
  }
  judge_others(m, set, result);
  state.model = beside_levels(design, weights, model_of(design, weights, parts, search, set));
  state.levels = parts.levels;
  for (Term& level : state.levels) level.freedom = search.freedom(level.level);
  state.made = parts.made;
  state.evidence.assign(state.model.terms.size() - set.size(), {});
  state.evidence.insert(state.evidence.end(), evidence.begin(), evidence.end());
  return result;
}

}  // namespace sinew::diagnosis
