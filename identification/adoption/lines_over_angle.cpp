// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/lines_over_angle.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "identification/diagnosis/confidence.h"
#include "symbolic/effects/effects.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using ShaftLine = DrivenSubject::ShaftLine;

bool is_named(const Candidate& ripple, const Verdict& verdict) {
  return std::any_of(verdict.causes.begin(), verdict.causes.end(), [&](const NamedCause& cause) {
    return std::any_of(cause.members.begin(), cause.members.end(), [&](const RankedCause& member) {
      return member.name == ripple.name && member.place == ripple.place;
    });
  });
}

/// A line in some logs.
struct LineInLogs {
  std::vector<LineFit> fits;
  std::vector<const Recording*> logs;
  double measured = 0.0, samples = 0.0;  ///< of the effort: sum of squares, and how many
};

LineInLogs line_in(const DrivenSubject& subject, const ShaftLine& line,
                   const std::vector<Recording>& logs, int blocks) {
  LineInLogs found;
  const auto axis = static_cast<Index>(line.joint);
  for (const Recording& log : logs) {
    const auto q = log.q.col(axis);
    if (!(q.maxCoeff() - q.minCoeff() >= line.turn)) continue;
    found.fits.push_back(
        fit_line(subject.shaft_log(line.joint, line.turn, log), line.line.order, blocks));
    found.logs.push_back(&log);
    found.measured += log.target[line.joint].squaredNorm();
    found.samples += static_cast<double>(log.target[line.joint].size());
  }
  return found;
}

Gain gain_of_line(const LineInLogs& line, const Settings& settings) {
  if (line.fits.empty()) return {};
  std::vector<double> without, with;
  for (const LineFit& fit : line.fits) {
    without.insert(without.end(), fit.without.begin(), fit.without.end());
    with.insert(with.end(), fit.with.begin(), fit.with.end());
  }
  return block_bootstrap_gain(VectorXd::Map(without.data(), static_cast<Index>(without.size())),
                              VectorXd::Map(with.data(), static_cast<Index>(with.size())), 0.95,
                              settings.seed);
}

/// Sine and cosine of every log, whose phase is its own.
std::vector<ParameterEstimate> amplitudes(const LineInLogs& line, const std::string& unit) {
  std::vector<ParameterEstimate> list;
  for (std::size_t i = 0; i < line.fits.size(); ++i) {
    const LineFit& fit = line.fits[i];
    for (const auto& [name, value, error] :
         {std::tuple{"sine", fit.sine, fit.sine_error}, {"cosine", fit.cosine, fit.cosine_error}}) {
      ParameterEstimate estimate;
      estimate.name = name;
      estimate.unit = unit;
      estimate.value = value;
      estimate.standard_error = error;
      if (line.fits.size() > 1) estimate.log = line.logs[i]->name;
      list.push_back(std::move(estimate));
    }
  }
  return list;
}

bool is_material(const LineInLogs& line, const Settings& settings) {
  double energy = 0.0;
  for (const LineFit& fit : line.fits)
    energy += 0.5 * (fit.sine * fit.sine + fit.cosine * fit.cosine) /
              static_cast<double>(line.fits.size());
  return energy > settings.material_share * settings.material_share * line.measured /
                      std::max(line.samples, 1.0);
}

}  // namespace

std::vector<NamedCause> lines_beside(const DrivenSubject& subject, const Verdict& verdict,
                                     const Settings& settings) {
  std::vector<NamedCause> causes;
  for (const ShaftLine& each : subject.shaft_lines()) {
    const Candidate& ripple = subject.problem().library[static_cast<std::size_t>(each.candidate)];
    if (is_named(ripple, verdict)) continue;
    const LineInLogs training = line_in(subject, each, subject.logged_training(), settings.blocks);
    const LineInLogs held_out = line_in(subject, each, subject.logged_holdout(), settings.blocks);
    NamedCause cause;
    cause.cross_validated = gain_of_line(training, settings);
    cause.held_out = cause.confirmed = gain_of_line(held_out, settings);
    // Blocks of one log differ in speed, and so in how much of the line their samples average
    // away: held-out logs say more, where there are any.
    const Gain& elsewhere = held_out.fits.empty() ? cause.cross_validated : cause.held_out;
    if (!is_material(training, settings) || !(elsewhere.low > 0.0)) continue;
    cause.candidate = kNoTerm;
    cause.log_odds = -std::log(std::max(each.line.chance, 1e-300));
    RankedCause member;
    member.candidate = each.candidate;
    member.name = ripple.name;
    member.place = ripple.place;
    member.weight = 1.0;
    cause.members.push_back(std::move(member));
    cause.confidence = confidence_of(2.0 * each.line.prominence, each.line.chance);
    cause.parameters = amplitudes(training, ripple.linear.front().unit);
    cause.separation.experiment = find_effect("ripple").experiment;
    causes.push_back(std::move(cause));
  }
  return causes;
}

}  // namespace sinew::diagnosis
