// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/verdict_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/diagnosis/materiality.h"
#include "identification/regression/held_bodies.h"
#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Of what was measured: root of the mean square of all channels together, or of the channels'
/// shares where they measure different things.
double relative_error(const Problem& problem, const ChannelSquares& sums) {
  if (!problem.unlike_channels)
    return std::sqrt(sums.error.sum() / std::max(sums.measured.sum(), 1e-300));
  return std::sqrt(sums.error.cwiseQuotient(sums.measured.cwiseMax(1e-300)).mean());
}

BlockLosses held_out_losses(const Design& design, const Settings& settings, const Model& model,
                            const Weights& weights) {
  return held_out(design, model, solve(stack(model, weights)), settings.blocks);
}

/// Of each channel, for how long its joint moves [s].
VectorXd time_of_motion(const Design& design, bool held_out) {
  VectorXd time = VectorXd::Zero(design.problem().channels);
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    const Segment& segment = design.segments()[i];
    if (segment.holdout != held_out) continue;
    time(segment.channel) += design.window(static_cast<int>(i)).squaredNorm() / segment.rate_hz;
  }
  return time;
}

/// Where the held-out logs leave most over, beside what the training logs do.
Disagreement most_excess(const Design& design, const Settings& settings, const Selection& after) {
  Disagreement most;
  const BlockLosses held = held_out_losses(design, settings, after.model, after.noise.weights);
  if (held.plain.size() == 0 || held.samples.sum() <= 0.0) return most;
  const VectorXd there = held.plain.colwise().sum(), moves_there = time_of_motion(design, true);
  const VectorXd here = cross_validate(design, after.model, after.noise.weights, settings.blocks)
                            .plain.colwise()
                            .sum();
  const VectorXd moves_here = time_of_motion(design, false);
  for (int c = 0; c < design.problem().channels; ++c) {
    if (here(c) <= 0.0 || std::min(moves_here(c), moves_there(c)) < kLeastMotion) continue;
    const double ratio = std::sqrt(there(c) / moves_there(c) * moves_here(c) / here(c));
    if (ratio <= most.ratio) continue;
    most.channel = c;
    most.ratio = ratio;
  }
  return most;
}

/// The lowest frequency above which a channel is left out, below the band asked for; 0: none is.
double cut_of(const Problem& problem, const Settings& settings) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Recording& log : problem.training)
    for (const double band : log.band_hz) lowest = std::min(lowest, band);
  const bool cut = std::isfinite(lowest) && (settings.band_hz <= 0.0 || lowest < settings.band_hz);
  return cut ? lowest : 0.0;
}

}  // namespace

/// Root mean square of what a model leaves of each channel in the training logs, all frequencies
/// alike.
VectorXd left_over(const Design& design, const Model& model) {
  Stack rows = stack(model, even_weights(design));
  rows.prior.setZero();  // is in units of the noise
  const LinearFit fit = solve(rows);
  VectorXd energy = VectorXd::Zero(design.problem().channels), count = energy;
  for (std::size_t s = 0; s < design.segments().size(); ++s) {
    const Segment& segment = design.segments()[s];
    const Index own = rows.first_row[s + 1] - rows.first_row[s];
    energy(segment.channel) += fit.residual.segment(rows.first_row[s], own).squaredNorm();
    count(segment.channel) += static_cast<double>(own);
  }
  return energy.cwiseQuotient(count.cwiseMax(1.0)).cwiseSqrt().cwiseMax(1e-12);
}

/// What a term gains on held-out logs beside the rest of the model.
WithAndWithout compared(const Design& design, const Model& model, std::size_t term,
                        const Weights& weights) {
  WithAndWithout m{model, model};
  const Term& own = model.terms[term];
  if (own.deviation >= 0 && !is_of_body(own)) {
    m.with = m.without = hold_bodies(design, model, weights);
    const auto before = model.terms.begin();
    term -= static_cast<std::size_t>(
        std::count_if(before, before + static_cast<std::ptrdiff_t>(term), is_of_body));
  }
  remove_term(design, term, m.without);
  return m;
}

Gain gain_on_held_out(const Design& design, const Settings& settings, const Selection& selection,
                      std::size_t term) {
  const Weights& weights = selection.noise.weights;
  const auto [with, without] = compared(design, selection.model, term, weights);
  const VectorXd channels = channels_of(design, selection.model.terms[term]);
  const BlockLosses before = held_out_losses(design, settings, without, weights);
  const BlockLosses after = held_out_losses(design, settings, with, weights);
  return block_bootstrap_gain(before.plain * channels, after.plain * channels, 0.95, settings.seed);
}

/// Errors before and after, and what all causes together gain on held-out logs.
void tell_errors(const Design& design, const Settings& settings, const Model& before,
                 const Selection& after, Verdict& verdict) {
  const NoiseView noise = own_noise(design, before);
  const ChannelSquares errors = channel_squares(design, before, noise.weights);
  const Problem& problem = design.problem();
  verdict.relative_error_before = relative_error(problem, errors);
  verdict.relative_error_after =
      relative_error(problem, channel_squares(design, after.model, after.noise.weights));
  const auto loss = [&](const Model& model, const Weights& weights) {
    return cross_validate(design, model, weights, settings.blocks).over_all().sum();
  };
  verdict.unexplained.remaining = std::min(
      loss(after.model, after.noise.weights) / std::max(loss(before, noise.weights), 1e-300), 1.0);
  const BlockLosses held = held_out_losses(design, settings, before, noise.weights);
  verdict.held_out = block_bootstrap_gain(
      held.over_all(),
      held_out_losses(design, settings, after.model, after.noise.weights).over_all(), 0.95,
      settings.seed);
  verdict.most_excess = most_excess(design, settings, after);
  remove_immaterial(
      problem,
      immaterial_channels(problem, errors, held_out_rms(design, held), settings.material_share),
      verdict);
  verdict.compared_below_hz = cut_of(problem, settings);
}

}  // namespace sinew::diagnosis
