// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/unexplained.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/regression/refine.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWorthSaying = 0.04;  // share of the remaining loss a dependence must explain
constexpr double kWorthALine = 0.06;   // of a line in the spectrum, sought at every frequency

bool is_unnamed(const Candidate& candidate) {
  return candidate.kind == CandidateKind::flexible || candidate.kind == CandidateKind::decoy;
}

/// A flexible family on top of a model.
struct Flexible {
  int candidate = -1;
  double p_family = 1.0;
  Model model;
  Gain gain;
  double loss = 0.0;
};

double plain_loss(const Design& design, const Settings& settings, const Model& model,
                  const NoiseView& noise) {
  return cross_validate(design, model, noise.weights, settings.blocks).plain.sum();
}

/// The flexible family that takes most of the loss away, if any is significant and worth it.
Flexible best_flexible(const Design& design, const Settings& settings, const Model& model,
                       const NoiseView& noise, const Screening& screening) {
  Flexible best;
  const BlockLosses before = cross_validate(design, model, noise.weights, settings.blocks);
  for (const Screened& s : screening.candidates) {
    const Candidate& c = design.problem().library[static_cast<std::size_t>(s.candidate)];
    if (c.kind != CandidateKind::flexible || s.gate != Gate::open) continue;
    const double p = screening.family.p_value(s.surprise);
    if (p > settings.significance) continue;
    Flexible trial{s.candidate, p, model, {}, 0.0};
    append_term(design, noise.weights, c, s.nonlinear, trial.model);
    refine(design, noise.weights, RefineScope::last_term, trial.model);
    const BlockLosses after = cross_validate(design, trial.model, noise.weights, settings.blocks);
    const Eigen::VectorXd channels = channels_of(design, trial.model.terms.back());
    trial.gain =
        block_bootstrap_gain(before.plain * channels, after.plain * channels, 0.95, settings.seed);
    trial.loss = after.plain.sum();
    if (trial.gain.share < kWorthSaying || trial.gain.low <= 0.0) continue;
    if (best.candidate < 0 || trial.loss < best.loss) best = std::move(trial);
  }
  return best;
}

Dependence describe(const Flexible& flexible) {
  const Term& term = flexible.model.terms.back();
  Dependence d{term.candidate->depends_on, term.candidate->place, flexible.p_family, flexible.gain};
  if (term.nonlinear.size() > 0)
    d.on += fmt::format(", period {:.3g} {}", 1.0 / term.nonlinear(0),
                        term.candidate->nonlinear.front().unit == "Hz" ? "s" : "of position");
  return d;
}

/// A decoy that was accepted is structure without a name: it leaves the model, and is listed with
/// what it explained.
std::vector<Dependence> take_out_decoys(const Design& design, Selection& selection) {
  std::vector<Dependence> list;
  for (std::size_t t = 0; t < selection.model.terms.size();) {
    const Term& term = selection.model.terms[t];
    if (term.baseline || term.candidate->kind != CandidateKind::decoy) {
      ++t;
      continue;
    }
    list.push_back({term.candidate->depends_on, term.candidate->place,
                    selection.evidence[t].p_family, selection.evidence[t].gain});
    remove_term(design, t, selection.model);
    selection.evidence.erase(selection.evidence.begin() + static_cast<std::ptrdiff_t>(t));
  }
  if (list.empty()) return list;
  selection.noise = own_noise(design, selection.model);
  refine(design, selection.noise.weights, RefineScope::all_terms, selection.model);
  selection.noise = own_noise(design, selection.model);
  return list;
}

bool is_name(const Term& term) {
  return !term.baseline && !term.candidate->nuisance && !is_unnamed(*term.candidate);
}

/// What the baseline and what is in every measurement leave over.
double loss_without_names(const Design& design, const Settings& settings,
                          const Selection& selection) {
  if (std::none_of(selection.model.terms.begin(), selection.model.terms.end(),
                   [](const Term& t) { return !t.baseline && t.candidate->nuisance; }))
    return selection.baseline_loss.sum();
  Model model = selection.model;
  for (std::size_t t = model.terms.size(); t-- > 0;)
    if (is_name(model.terms[t])) remove_term(design, t, model);
  return plain_loss(design, settings, model, own_noise(design, model));
}

/// Names whose part the unnamed terms take over, and names of less than what has no name.
void withdraw(const Design& design, const Settings& settings, const Model& with_flexible,
              Selection& selection, Unexplained& result) {
  const NoiseView noise = own_noise(design, with_flexible);
  const double full = plain_loss(design, settings, with_flexible, noise);
  const double named = plain_loss(design, settings, selection.model, selection.noise);
  std::vector<const Candidate*> gone;
  for (std::size_t t = 0; t < with_flexible.terms.size(); ++t) {
    const Term& term = with_flexible.terms[t];
    if (!is_name(term)) continue;
    Model without = with_flexible;
    remove_term(design, t, without);
    const double beside = plain_loss(design, settings, without, noise) - full;
    Model alone = selection.model;
    std::size_t at = 0;
    while (alone.terms[at].candidate != term.candidate) ++at;
    remove_term(design, at, alone);
    const double before = plain_loss(design, settings, alone, selection.noise) - named;
    if (before < named - full || beside < kStandsAlone * before) gone.push_back(term.candidate);
  }
  for (const Candidate* candidate : gone) {
    std::size_t at = 0;
    while (selection.model.terms[at].candidate != candidate) ++at;
    remove_term(design, at, selection.model);
    selection.evidence.erase(selection.evidence.begin() + static_cast<std::ptrdiff_t>(at));
    result.withdrawn.push_back(candidate->name);
  }
}

/// What a model leaves over of one segment, every coefficient fitted to it alone.
VectorXd left_over_in(const Model& model, std::size_t segment) {
  Index wide = 0;
  for (const Term& term : model.terms) wide += term.columns[segment].cols();
  const VectorXd& target = model.target[segment];
  MatrixXd x(target.size(), wide);
  wide = 0;
  for (const Term& term : model.terms) {
    const MatrixXd& own = term.columns[segment];
    if (own.cols() == 0) continue;  // does not act on this channel
    x.middleCols(wide, own.cols()) = own;
    wide += own.cols();
  }
  return target - x * (scaled_pseudo_inverse(x.transpose() * x) * (x.transpose() * target));
}

/// Names that `kept` no longer has leave the model with the unnamed terms as well.
void take_out_withdrawn(const Design& design, const Model& kept, Model& beside) {
  for (std::size_t t = beside.terms.size(); t-- > 0;) {
    const Candidate* own = beside.terms[t].candidate;
    const bool stays = std::any_of(kept.terms.begin(), kept.terms.end(),
                                   [own](const Term& k) { return k.candidate == own; });
    if (!stays && !is_unnamed(*own)) remove_term(design, t, beside);
  }
}

/// What the bins around a line hold, without the line: mean energy, and of how many bins.
struct Surroundings {
  double mean = 0.0, bins = 0.0;
};

Surroundings around_line(const VectorXd& energy, Index line, Index half) {
  const Index low = std::max<Index>(0, line - half),
              high = std::min(energy.size(), line + half + 1);
  const double bins = static_cast<double>(high - low - 5);
  return {(energy.segment(low, high - low).sum() - energy.segment(line - 2, 5).sum()) / bins, bins};
}

/// Probability that a bin of such surroundings is as large by chance: an exponential variable over
/// the mean of `bins` others.
double chance_of_line(double peak, const Surroundings& beside) {
  return beside.mean > 0.0 ? std::pow(1.0 + peak / (beside.bins * beside.mean), -beside.bins) : 0.0;
}

}  // namespace

SpectralLine strongest_line(const Design& design, const Model& model) {
  constexpr Index kNearest = 8, kWide = 12;  // bins to each side; the wide ones grow with frequency
  constexpr double kGrowth = 0.12;
  SpectralLine best;
  double tests = 0.0, all = 0.0, in_line = 0.0;
  for (const Segment& s : design.segments())
    if (!s.holdout) tests += static_cast<double>(s.bins);
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    const Segment& s = design.segments()[i];
    if (s.holdout) continue;
    const double unit = design.unit(s.channel);
    const VectorXd energy = bin_energy(left_over_in(model, i)) / (unit * unit);
    all += energy.sum();
    for (Index b = 2; b + 2 < s.bins; ++b) {
      const double peak = energy.segment(b - 1, 3).maxCoeff();
      const Index wide = std::max(kWide, static_cast<Index>(kGrowth * static_cast<double>(b)));
      const Surroundings far = around_line(energy, b, wide);
      // Where the noise rises towards slow frequencies the nearest bins say more than all.
      const Surroundings near = around_line(energy, b, kNearest);
      const double single = std::max(chance_of_line(peak, far), chance_of_line(peak, near));
      const double p = -std::expm1(tests * std::log1p(-std::min(single, 0.999999)));
      if (p >= best.p_value) continue;
      in_line = energy.segment(b - 1, 3).sum() - 3.0 * std::max(far.mean, near.mean);
      best = {static_cast<double>(b) * s.rate_hz / static_cast<double>(s.samples), p,
              in_line / energy.sum(), 0.0};
    }
  }
  if (in_line > 0.0) best.of_all = in_line / all;
  return best;
}

Structure find_unexplained(const Design& design, const Library& library, const Settings& settings,
                           Selection& selection) {
  Structure structure;
  Unexplained& result = structure.said;
  Model& model = structure.beside;
  model = selection.model;
  NoiseView noise = selection.noise;
  result.depends_on = take_out_decoys(design, selection);
  const double named = plain_loss(design, settings, selection.model, selection.noise);
  double last = result.depends_on.empty() ? named : plain_loss(design, settings, model, noise);
  for (int round = 0; round < 3; ++round) {
    draw_surrogates(design, settings, noise);
    const Screening screening =
        screen(design, library, model, noise.weights, noise.surrogates, Scope::everything);
    Flexible best = best_flexible(design, settings, model, noise, screening);
    if (best.candidate < 0) break;
    result.depends_on.push_back(describe(best));
    model = std::move(best.model);
    noise = own_noise(design, model);
    last = best.loss;
  }
  std::stable_sort(
      result.depends_on.begin(), result.depends_on.end(),
      [](const Dependence& a, const Dependence& b) { return a.gain.share > b.gain.share; });
  const SpectralLine line = strongest_line(design, model);
  // A line that stands out and is next to nothing is worth nobody's time.
  if (line.p_value < settings.significance && line.share > kWorthALine) {
    Dependence d;
    d.on = fmt::format("time, periodically, {:.3g} Hz", line.frequency_hz);
    d.p_family = line.p_value;
    d.gain.share = d.gain.low = d.gain.high = line.share;
    result.depends_on.push_back(d);
    last *= 1.0 - line.of_all;
  }
  if (result.depends_on.empty()) return structure;
  const double base = loss_without_names(design, settings, selection);
  result.named_share = base > last ? std::clamp((base - named) / (base - last), 0.0, 1.0) : 0.0;
  const bool any_name = std::any_of(selection.model.terms.begin(), selection.model.terms.end(),
                                    [](const Term& t) { return is_name(t); });
  if (any_name && result.named_share < kNamesHold)
    withdraw(design, settings, model, selection, result);
  result.none_of_the_known = !any_name || result.named_share < kNamesHold;
  take_out_withdrawn(design, selection.model, model);
  structure.left =
      last / (result.withdrawn.empty() ? named
                                       : plain_loss(design, settings, selection.model,
                                                    own_noise(design, selection.model)));
  return structure;
}

}  // namespace sinew::diagnosis
