// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/unlogged_force.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "identification/diagnosis/confidence.h"
#include "identification/likelihood/decision_constants.h"
#include "symbolic/effects/model_effects.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// In twice the log likelihood: what each push has to be worth, and what is no member of the set.
const double kPrior = -2.0 * std::log(kPriorOdds);
const double kSet = -2.0 * std::log(1.0 - kCredible);

/// Of what the logs leave over as a whole.
double log_loss_of(const std::vector<LeftOver>& logs, const ForceNoise& noise) {
  double sum = 0.0;
  for (const LeftOver& r : logs)
    for (Index k = 0; k < r.time.size(); ++k) sum += log_loss_at(noise, r, k);
  return noise.independent * sum;
}

/// Squared errors of the training logs or of the held-out ones, every channel by its level.
double plain_error(const std::vector<LeftOver>& logs, const VectorXd& level, bool held_out) {
  double sum = 0.0;
  for (const LeftOver& r : logs)
    if (r.held_out == held_out)
      sum +=
          (r.residual.cwiseProduct(r.counts) * level.cwiseMax(1e-300).cwiseInverse().asDiagonal())
              .squaredNorm();
  return sum;
}

std::vector<LeftOver> without_disturbances(const Disturbances& disturbances) {
  std::vector<LeftOver> rest = disturbances.left_over;
  for (const Disturbance& d : disturbances.list)
    rest[d.recording].residual.middleRows(d.first, d.last - d.first).setZero();
  return rest;
}

/// No interval: how often something pushes in a log tells nothing of the next one.
Gain gain_between(const std::vector<LeftOver>& before, const std::vector<LeftOver>& after,
                  const VectorXd& level, bool held_out) {
  Gain gain;
  const double whole = plain_error(before, level, held_out);
  if (whole > 0.0)
    gain.share = std::clamp(1.0 - plain_error(after, level, held_out) / whole, 0.0, 1.0);
  gain.low = gain.high = gain.share;
  return gain;
}

/// In held-out logs alone it is none: the logs disagree.
bool is_pushed_in_training(const ForceFit& fit, const Disturbances& disturbances) {
  for (std::size_t d = 0; d < fit.forces.size(); ++d)
    if (fit.forces[d].worth > kPrior &&
        !disturbances.left_over[disturbances.list[d].recording].held_out)
      return true;
  return false;
}

std::vector<RankedCause> members_of(const std::vector<ForceFit>& fits) {
  const std::string name = find_model_effect("unlogged_force")->name;
  std::vector<RankedCause> members;
  double all = 0.0;
  for (const ForceFit& fit : fits) {
    const double behind = fit.score() - fits.front().score();
    all += std::exp(-0.5 * behind);
    if (behind > kSet) continue;
    RankedCause member;
    member.candidate = kNoTerm;
    member.name = name;
    member.place = fit.place->name;
    member.behind = 0.5 * behind;
    member.weight = std::exp(-0.5 * behind);
    members.push_back(member);
  }
  for (RankedCause& member : members) member.weight /= all;
  return members;
}

std::vector<ParameterEstimate> peaks_of(const ForceFit& fit, const Disturbances& disturbances,
                                        const std::vector<std::string>& names) {
  std::vector<ParameterEstimate> peaks(1);  // the largest comes first, of no log
  for (std::size_t d = 0; d < fit.forces.size(); ++d) {
    if (fit.forces[d].worth < kPrior) continue;  // more may have been set aside than was pushed
    const Disturbance& one = disturbances.list[d];
    const LeftOver& r = disturbances.left_over[one.recording];
    ParameterEstimate peak;
    peak.name = "peak";
    peak.unit = fit.place->unit;
    peak.value = fit.forces[d].peak;
    peak.standard_error = fit.forces[d].peak_error;
    peak.log = fmt::format("{}, {:.2f} to {:.2f} s", names[static_cast<std::size_t>(r.recording)],
                           r.time(one.first), r.time(one.last - 1));
    if (peak.value >= peaks.front().value) {
      peaks.front() = peak;
      peaks.front().log.clear();
    }
    peaks.push_back(std::move(peak));
  }
  return peaks;
}

}  // namespace

std::optional<NamedCause> find_unlogged_force(const Alternative& alternative, double numbers,
                                              const Disturbances& disturbances,
                                              const std::vector<ForcePlace>& places,
                                              const std::vector<std::string>& names,
                                              const Settings& settings) {
  const ForceNoise noise = force_noise(disturbances, settings.material_share);
  std::vector<ForceFit> fits(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(),
                    [&](std::size_t i) { fits[i] = fit_force(disturbances, noise, places[i]); });
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ForceFit& a, const ForceFit& b) { return a.score() < b.score(); });
  std::vector<SetAside> none;
  for (std::size_t i = 0; i < alternative.fit.recordings(); ++i)
    none.push_back(SetAside::Constant(alternative.fit.samples(i), false));
  const std::vector<LeftOver> by_whole =
      alternative.fit(none, disturbances.training.moving.cwiseMax(1e-300));
  double with_force = log_loss_of(disturbances.left_over, noise) + noise.price * numbers;
  for (const FittedForce& force : fits.front().forces)
    if (force.worth > kPrior) with_force -= force.worth - kPrior;
  const double without = log_loss_of(by_whole, noise) + noise.price * alternative.numbers;
  const double statistic = without - with_force;
  if (!is_pushed_in_training(fits.front(), disturbances) ||
      !(statistic > -2.0 * std::log(settings.significance)))
    return std::nullopt;

  NamedCause cause;
  cause.candidate = kNoTerm;
  cause.members = members_of(fits);
  cause.log_odds = 0.5 * statistic;
  const std::vector<LeftOver> rest = without_disturbances(disturbances);
  cause.cross_validated = gain_between(by_whole, rest, disturbances.training.moving, false);
  cause.held_out = cause.confirmed =
      gain_between(by_whole, rest, disturbances.training.moving, true);
  if (cause.cross_validated.share < settings.least_share) return std::nullopt;
  const double margin = cause.members.size() < fits.size()
                            ? fits[cause.members.size()].score() - fits.front().score()
                            : statistic;
  cause.confidence = confidence_of(margin, std::exp(-cause.log_odds));
  cause.separation.experiment = find_model_effect("unlogged_force")->experiment;
  cause.parameters = peaks_of(fits.front(), disturbances, names);
  return cause;
}

std::vector<std::vector<Standstill>> stretches_in_time(const Disturbances& disturbances) {
  std::vector<std::vector<Standstill>> all(disturbances.left_over.size());
  for (const Disturbance& d : disturbances.list) {
    const VectorXd& time = disturbances.left_over[d.recording].time;
    all[d.recording].push_back({time(d.first), time(d.last - 1)});
  }
  return all;
}

}  // namespace sinew::diagnosis
