// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/held_out_judge.h"

#include <algorithm>
#include <utility>

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

std::vector<NamedCause> HeldOutJudge::withdrawn(std::vector<NamedCause>& list,
                                                Selection& adopted) const {
  std::vector<NamedCause> gone;
  Model& model = adopted.model;
  const std::size_t first = model.terms.size() - list.size();
  for (std::size_t i = 0; i < list.size(); ++i) list[i].confirmed = confirmed(model, first + i);
  const auto less_sure = [](const NamedCause& a, const NamedCause& b) {
    return standard_errors_above_zero(a.confirmed) < standard_errors_above_zero(b.confirmed);
  };
  while (!design_.problem().holdout.empty() && !list.empty()) {
    const auto least = std::min_element(list.begin(), list.end(), less_sure);
    if (is_sure(least->confirmed)) break;
    const std::size_t term = first + static_cast<std::size_t>(least - list.begin());
    adopted.noise = own_noise(design_, model);
    measure(adopted, term, *least);
    const VectorXd channels = channels_of(design_, model.terms[term]);
    gone.push_back(std::move(*least));
    list.erase(least);
    remove_term(design_, term, model);
    for (std::size_t i = 0; i < list.size(); ++i)
      if (channels_of(design_, model.terms[first + i]).dot(channels) > 0.0)
        list[i].confirmed = confirmed(model, first + i);
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
