// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/held_out_judge.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "identification/diagnosis/confirmation.h"
#include "identification/diagnosis/verdict_errors.h"
#include "identification/likelihood/slot_verdict.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::VectorXd;

Gain cross_validated_gain(const Design& design, const Settings& settings,
                          const Selection& selection, std::size_t term) {
  const Weights& weights = selection.noise.weights;
  const auto [with, without] = compared(design, selection.model, term, weights);
  const VectorXd channels = channels_of(design, selection.model.terms[term]);
  return block_bootstrap_gain(
      cross_validate(design, without, weights, settings.blocks).plain * channels,
      cross_validate(design, with, weights, settings.blocks).plain * channels, 0.95, settings.seed);
}

bool is_of_one_log(const Candidate& c) {
  return c.of_its_time || std::any_of(c.linear.begin(), c.linear.end(),
                                      [](const LinearParameter& p) { return p.per_log; });
}

}  // namespace

Gain HeldOutJudge::confirmed(const Model& whole, std::size_t term) const {
  const Whitening& whitening = found_.whitening;
  const auto [with, without] = compared(design_, whole, term, whitening.training);
  const VectorXd channels = channels_of(design_, whole.terms[term]);
  const std::vector<Segment>& segments = design_.segments();
  const auto errors = [&](const Model& model) {
    const LinearFit fit = solve(stack(model, whitening.training));
    std::vector<VectorXd> of_segment =
        held_out_errors(design_, model, fit, settings_.blocks, whitening.held_out);
    for (std::size_t s = 0; s < segments.size(); ++s)
      if (channels(segments[s].channel) == 0.0) of_segment[s].resize(0);
    return of_segment;
  };
  return likelihood_gain(errors(without), errors(with));
}

void HeldOutJudge::measure(const Selection& selection, std::size_t term, NamedCause& cause) const {
  cause.parameters = told_estimates(design_, selection.model, selection.noise)[term];
  cause.cross_validated = cross_validated_gain(design_, settings_, selection, term);
  cause.held_out = gain_on_held_out(design_, settings_, selection, term);
}

/// The model with a member of a set in the place of a term, its shape the best that the search has
/// of it, fitted; none where it could not be there.
std::optional<Model> HeldOutJudge::with_member(const Model& whole, std::size_t term,
                                               const RankedCause& member) const {
  const auto& list = found_.all.list;
  const auto h = std::find_if(list.begin(), list.end(),
                              [&](const Hypothesis& x) { return x.candidate == member.candidate; });
  const auto moves = [](const Candidate& c) { return c.kind == CandidateKind::delay; };
  // A delay is no term in the place of another: all of them move with it.
  if (h == list.end() || moves(*h->source) || moves(*whole.terms[term].candidate))
    return std::nullopt;
  const Weights& weights = found_.whitening.training;
  Model best = whole, tried = whole;
  double least = std::numeric_limits<double>::infinity();
  for (const int shape : h->shapes) {
    tried.terms[term] =
        h->candidate < 0
            ? term_of(found_.all, shape)
            : make_term(design_, *h->source,
                        found_.all.shapes[static_cast<std::size_t>(shape)].nonlinear, false);
    tried.terms[term].with_prior = true;
    const double here = deviance(tried, weights);
    if (here < least) least = here, best = tried;
  }
  refine(design_, weights, best);
  if (is_beyond_limits(design_, best, solve(stack(best, weights)), term)) return std::nullopt;
  return best;
}

bool HeldOutJudge::gives_way(std::size_t term, NamedCause& cause, Selection& adopted,
                             std::vector<NamedCause>& gone) const {
  std::vector<RankedCause>& set = cause.members;
  const auto likelier = [](const RankedCause& a, const RankedCause& b) {
    return a.behind < b.behind;
  };
  const double best = std::min_element(set.begin(), set.end(), likelier)->behind;
  for (auto member = set.begin() + 1; member < set.end(); ++member) {
    const std::optional<Model> other = with_member(adopted.model, term, *member);
    if (!other) continue;
    const Gain gain = confirmed(*other, term);
    if (!is_sure(gain)) continue;
    gone.push_back(cause);
    gone.back().members.erase(gone.back().members.begin() + 1, gone.back().members.end());
    adopted.model = *other;
    cause.confirmed = gain;
    cause.candidate = member->candidate;
    const double behind = member->behind;
    cause.log_odds -= behind - best;
    const std::vector<RankedCause> refuted(set.begin(), member);
    set.erase(set.begin(), member);
    std::erase_if(set, [&](const RankedCause& left) {
      return std::any_of(refuted.begin(), refuted.end(), [&](const RankedCause& out) {
        return out.name == left.name && out.place == left.place;
      });
    });
    for (RankedCause& left : set) left.behind -= behind;
    return true;
  }
  return false;
}

void HeldOutJudge::measure_unsure(std::size_t term, NamedCause& cause, Selection& adopted) const {
  adopted.noise = own_noise(design_, adopted.model);
  measure(adopted, term, cause);
  const auto [with, without] = compared(design_, adopted.model, term, adopted.noise.weights);
  cause.left_without =
      left_over(design_, without).cwiseQuotient(left_over(design_, with)).maxCoeff();
}

std::vector<NamedCause> HeldOutJudge::withdrawn(std::vector<NamedCause>& list,
                                                Selection& adopted) const {
  std::vector<NamedCause> gone;
  Model& model = adopted.model;
  const std::size_t first = model.terms.size() - list.size();
  for (std::size_t i = 0; i < list.size(); ++i) list[i].confirmed = confirmed(model, first + i);
  const auto less_sure = [](const NamedCause& a, const NamedCause& b) {
    if (a.stands != b.stands) return b.stands;
    return standard_errors_above_zero(a.confirmed) < standard_errors_above_zero(b.confirmed);
  };
  while (!design_.problem().holdout.empty() && !list.empty()) {
    const auto least = std::min_element(list.begin(), list.end(), less_sure);
    if (least->stands || is_sure(least->confirmed)) break;
    const std::size_t term = first + static_cast<std::size_t>(least - list.begin());
    const VectorXd channels = channels_of(design_, model.terms[term]);
    const auto judge_others = [&](std::size_t but) {
      for (std::size_t i = 0; i < list.size(); ++i)
        if (i != but && channels_of(design_, model.terms[first + i]).dot(channels) > 0.0)
          list[i].confirmed = confirmed(model, first + i);
    };
    if (gives_way(term, *least, adopted, gone)) {
      judge_others(static_cast<std::size_t>(least - list.begin()));
      continue;
    }
    measure_unsure(term, *least, adopted);
    least->stands = is_confirmed(*least);
    if (least->stands) continue;
    gone.push_back(std::move(*least));
    list.erase(least);
    remove_term(design_, term, model);
    judge_others(list.size());
  }
  if (gone.empty()) return gone;
  // The others' shapes were fitted beside what is gone.
  refine(design_, own_noise(design_, model).weights, model);
  adopted.noise = own_noise(design_, model);
  return gone;
}

std::vector<NamedCause> HeldOutJudge::causes(const std::vector<NamedCause>& of_slot,
                                             Selection& adopted) const {
  std::vector<NamedCause> list;
  for (const NamedCause& cause : of_slot)
    if (!cause.members.empty()) list.push_back(cause);
  std::vector<NamedCause> gone = withdrawn(list, adopted);
  const std::size_t first = adopted.model.terms.size() - list.size();
  for (std::size_t i = 0; i < list.size(); ++i) measure(adopted, first + i, list[i]);
  std::move(gone.begin(), gone.end(), std::back_inserter(list));
  std::stable_sort(list.begin(), list.end(), [](const NamedCause& a, const NamedCause& b) {
    return a.cross_validated.share > b.cross_validated.share;
  });
  return list;
}

bool HeldOutJudge::is_told_structure(std::size_t slot) const {
  return !hypothesis_of(found_, slot).named && is_told(found_, slot);
}

std::optional<Gain> HeldOutJudge::confirmed_structure(std::size_t slot) const {
  if (is_of_one_log(*hypothesis_of(found_, slot).source)) return std::nullopt;
  const std::size_t first = found_.model.terms.size() - found_.slots.entries.size();
  return confirmed(found_.model, first + slot);
}

bool HeldOutJudge::refutes_structure() const {
  if (design_.problem().holdout.empty()) return false;
  bool any = false;
  for (std::size_t i = 0; i < found_.slots.entries.size(); ++i) {
    if (hypothesis_of(found_, i).named) continue;
    any = true;
    if (!is_told(found_, i)) continue;
    const std::optional<Gain> gain = confirmed_structure(i);
    if (!gain || is_sure(*gain)) return false;
  }
  return any;
}

void HeldOutJudge::confirm_structure(std::vector<Dependence>& depends_on) const {
  if (design_.problem().holdout.empty()) return;
  auto said = depends_on.begin();
  for (std::size_t i = 0; i < found_.slots.entries.size() && said != depends_on.end(); ++i)
    if (is_told_structure(i)) (said++)->confirmed = confirmed_structure(i);
}

}  // namespace sinew::diagnosis
