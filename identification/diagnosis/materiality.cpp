// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/materiality.h"

#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {

using Eigen::VectorXd;

ChannelSquares channel_squares(const Design& design, const Model& model, const Weights& weights) {
  const LinearFit fit = solve(stack(model, weights));
  std::vector<const BandColumns*> columns;
  for (const Term& term : model.terms) columns.push_back(&term.columns.get());
  const VectorXd none = VectorXd::Zero(design.problem().channels);
  ChannelSquares sums{none, none, none};
  for (std::size_t s = 0; s < design.segments().size(); ++s) {
    if (design.segments()[s].holdout) continue;
    const int segment = static_cast<int>(s);
    const VectorXd prediction = predict(columns, fit.coefficients, s);
    const auto c = design.segments()[s].channel;
    sums.error(c) += (prediction.size() ? VectorXd(model.target[s] - prediction) : model.target[s])
                         .squaredNorm();
    VectorXd measured = design.target(segment, model.advance[s]);
    if (const auto known = design.known(segment, 0)) measured += *known;
    sums.measured(c) += measured.squaredNorm();
    sums.samples(c) += design.window(segment).squaredNorm();
  }
  return sums;
}

double immaterial_error(double rms, double quantum, double share) {
  return std::max(share * rms, quantum / std::sqrt(12.0));
}

VectorXd held_out_rms(const Design& design, const BlockLosses& losses) {
  VectorXd rms = VectorXd::Zero(design.problem().channels), count = rms;
  for (std::size_t s = 0; s < design.segments().size(); ++s)
    if (design.segments()[s].holdout)
      count(design.segments()[s].channel) += design.window(static_cast<int>(s)).squaredNorm();
  for (int c = 0; c < design.problem().channels; ++c)
    if (count(c) > 0.0) rms(c) = design.unit(c) * std::sqrt(losses.plain.col(c).sum() / count(c));
  return rms;
}

std::vector<bool> immaterial_channels(const Problem& problem, const ChannelSquares& errors,
                                      const VectorXd& held_out, double share) {
  std::vector<bool> list;
  for (int c = 0; c < problem.channels; ++c) {
    const double count = std::max(errors.samples(c), 1.0);
    const double quantum =
        problem.quantum.empty() ? 0.0 : problem.quantum[static_cast<std::size_t>(c)];
    list.push_back(std::max(std::sqrt(errors.error(c) / count), held_out(c)) <=
                   immaterial_error(std::sqrt(errors.measured(c) / count), quantum, share));
  }
  return list;
}

void remove_immaterial(const Problem& problem, const std::vector<bool>& immaterial,
                       Verdict& verdict) {
  const bool all = std::all_of(immaterial.begin(), immaterial.end(), [](bool b) { return b; });
  const auto says_nothing = [&](const NamedCause& cause) {
    if (all) return true;
    if (cause.candidate < 0) return false;
    const std::vector<int>& own =
        problem.library[static_cast<std::size_t>(cause.candidate)].channels;
    return !own.empty() && std::all_of(own.begin(), own.end(), [&](int c) {
      return immaterial[static_cast<std::size_t>(c)];
    });
  };
  for (const NamedCause& cause : verdict.causes)
    if (says_nothing(cause))
      verdict.ruled_out.push_back({cause.members.front().name, cause.members.front().place,
                                   "all that the model leaves over there is immaterial",
                                   cause.log_odds});
  std::erase_if(verdict.causes, says_nothing);
  const int most = verdict.most_excess.channel;
  if (most >= 0 && immaterial[static_cast<std::size_t>(most)]) verdict.most_excess = {};
  verdict.immaterial = all;
  if (all) verdict.unexplained = {};
}

}  // namespace sinew::diagnosis
