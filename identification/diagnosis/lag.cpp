// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/lag.h"

#include <algorithm>

#include "identification/regression/refine.h"

namespace sinew::diagnosis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kBent = 9.0;  // variances

/// The lag at the place where a delay is; the library's end where there is none.
auto lag_at(const std::vector<Candidate>& library, const Candidate& delay) {
  return std::find_if(library.begin(), library.end(), [&](const Candidate& c) {
    return c.bend && c.channels.front() == delay.channels.front();
  });
}

}  // namespace

std::optional<LagBehind> lag_behind_delay(const Design& design, const Selection& state,
                                          std::size_t term) {
  const Term& delay = state.model.terms[term];
  const std::vector<Candidate>& library = design.problem().library;
  if (delay.candidate->kind != CandidateKind::delay || delay.candidate->channels.empty()) return {};
  if (delay.nonlinear(0) <= 0.0) return {};  // of the effort, not of the position
  const auto lag = lag_at(library, *delay.candidate);
  if (lag == library.end()) return {};
  Candidate bend;
  bend.channels = {lag->channels.front()};
  bend.linear.resize(1);
  bend.columns = [&](const Recording& log, int channel, const VectorXd& none) -> MatrixXd {
    // A delay d shifts the position by d q' + d^2 / 2 q'', a lag by d q' alone.
    return 0.5 * delay.nonlinear(0) * delay.nonlinear(0) * lag->bend(log, channel, none);
  };
  Model bent = state.model;
  bent.terms.push_back(make_term(design, bend, VectorXd(), false));
  const LinearFit fit = solve(stack(bent, state.noise.weights));
  const double variance = fit.covariance.bottomRightCorner<1, 1>()(0, 0);
  if (!(variance > 0.0)) return {};
  const double of_delay = fit.coefficients(fit.coefficients.size() - 1), of_lag = of_delay + 1.0;
  const NonlinearParameter& size = lag->nonlinear.front();
  const VectorXd at = VectorXd::Constant(1, std::clamp(delay.nonlinear(0), size.low, size.high));
  LagBehind result{static_cast<int>(lag - library.begin()), 0.0, design.columns(*lag, at)};
  result.deviance = (of_lag * of_lag - of_delay * of_delay) / variance;
  // Logs bent by something else rule neither out.
  if (of_delay * of_delay >= kBent * variance) result.deviance = std::min(0.0, result.deviance);
  return result;
}

}  // namespace sinew::diagnosis
