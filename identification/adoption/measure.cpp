// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/measure.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "identification/adoption/measure_plots.h"
#include "identification/diagnosis/verdict_errors.h"
#include "identification/regression/position_noise.h"
#include "identification/subjects/effect_candidate.h"
#include "symbolic/effects/effects.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Residual less what the columns explain; each half is fitted on the other.
VectorXd crosswise(const VectorXd& residual, const MatrixXd& columns) {
  const Index half = residual.size() / 2, rest = residual.size() - half;
  VectorXd out = residual;
  const VectorXd first = columns.topRows(half).colPivHouseholderQr().solve(residual.head(half));
  const VectorXd second = columns.bottomRows(rest).colPivHouseholderQr().solve(residual.tail(rest));
  out.head(half) -= columns.topRows(half) * second;
  out.tail(rest) -= columns.bottomRows(rest) * first;
  return out;
}

/// As the effects of tendons take the measured forces: a term with all of a sensor's noise, which
/// is in the joints' torques as well, would find itself. A motor's load is the force as it is.
Recording with_slow_tension(const Recording& log) {
  Recording slow = log;
  if (const MatrixXd* tension = log.signals.find("slow_tension"))
    slow.signals["tension"] = *tension;
  return slow;
}

/// The per-log terms that act on a channel: their columns, filtered.
MatrixXd nuisance_columns(const DrivenSubject& subject, const Design& design, int segment,
                          const std::vector<ExtensionTerm>& terms) {
  const Segment& s = design.segments()[static_cast<std::size_t>(segment)];
  const Recording& log = design.recording(s.recording);
  MatrixXd all(s.samples, 0);
  for (const ExtensionTerm& term : terms) {
    if (!term.per_log) continue;
    const auto axis = static_cast<std::size_t>(s.channel);
    if (subject.model().joints[axis].name != term.entry.place) continue;
    VectorXd shape(static_cast<Index>(term.entry.shape.size()));
    for (Index k = 0; k < shape.size(); ++k)
      shape(k) = term.entry.shape[static_cast<std::size_t>(k)].value;
    const MatrixXd raw =
        effect_columns(Regressor(find_effect(term.entry.effect)), log, s.channel, shape);
    const MatrixXd filtered = design.filtered(segment, raw);
    all.conservativeResize(Eigen::NoChange, all.cols() + filtered.cols());
    all.rightCols(filtered.cols()) = filtered;
  }
  return all;
}

}  // namespace

EffortModel extended_effort(const DrivenSubject& subject, std::vector<ExtensionTerm> terms) {
  std::erase_if(terms, [](const ExtensionTerm& t) { return t.per_log; });
  return subject.effort_with(extended(subject.identified(), terms));
}

std::vector<MeasuredChannel> measure(const DrivenSubject& subject, const Design& design,
                                     const std::vector<ExtensionTerm>& terms,
                                     const EffortModel& after) {
  std::vector<MeasuredChannel> result;
  // Of every log once: a log has a segment for each channel.
  std::map<int, std::pair<MatrixXd, MatrixXd>> efforts;
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    const Segment& s = design.segments()[i];
    const Recording& log = design.recording(s.recording);
    const int segment = static_cast<int>(i);
    if (!efforts.contains(s.recording)) {
      const Recording seen = with_slow_tension(log);
      const Motion read = motion_as_read(log);
      efforts[s.recording] = {subject.effort()(seen, read.q, read.qd, read.qdd),
                              after(seen, read.q, read.qd, read.qdd)};
    }
    const auto& [said_before, said_after] = efforts[s.recording];
    MeasuredChannel m;
    m.recording = s.recording;
    m.channel = s.channel;
    m.held_out = s.holdout;
    m.step = 1.0 / s.rate_hz;
    m.band_hz = s.filter.band_hz;
    m.counts = design.motion_window_of(segment);
    const auto axis = static_cast<Index>(s.channel);
    m.time = design.at_instants(segment, log.time);
    m.position = design.at_instants(segment, log.q.col(axis));
    m.velocity = design.at_instants(segment, log.qd.col(axis));
    if (log.load.size() > 0) m.load = design.at_instants(segment, log.load.col(axis));
    m.measured = design.filtered(segment, log.target[static_cast<std::size_t>(s.channel)]);
    m.before = design.filtered(segment, said_before.col(axis));
    const VectorXd said = design.filtered(segment, said_after.col(axis));
    const MatrixXd nuisance = nuisance_columns(subject, design, segment, terms);
    m.after =
        nuisance.cols() == 0 ? said : VectorXd(m.measured - crosswise(m.measured - said, nuisance));
    result.push_back(std::move(m));
  }
  return result;
}

bool judged_on_held_out(const std::vector<MeasuredChannel>& measured) {
  return std::any_of(measured.begin(), measured.end(), [](const auto& m) { return m.held_out; });
}

namespace {

/// Those of one channel, or of all (-1), on the logs that errors are told of.
std::vector<const MeasuredChannel*> judged(const std::vector<MeasuredChannel>& measured,
                                           int channel) {
  const bool held_out = judged_on_held_out(measured);
  std::vector<const MeasuredChannel*> list;
  for (const MeasuredChannel& m : measured)
    if (m.held_out == held_out && (channel < 0 || m.channel == channel)) list.push_back(&m);
  return list;
}

VectorXd counts_of(const MeasuredChannel& m) {
  return m.counts.size() > 0 ? m.counts : VectorXd::Ones(m.measured.size());
}

VectorXd error_before(const MeasuredChannel& m) {
  return counts_of(m).cwiseProduct(m.measured - m.before);
}

VectorXd error_after(const MeasuredChannel& m) {
  return counts_of(m).cwiseProduct(m.measured - m.after);
}

/// Sums over one channel's samples, standstill aside.
struct ErrorSums {
  double count = 0.0, samples = 0.0, energy = 0.0, variance = 0.0, before = 0.0, after = 0.0;
  double band_hz = 0.0;
};

ErrorSums error_sums(const std::vector<MeasuredChannel>& measured, int channel) {
  ErrorSums sums;
  for (const MeasuredChannel* m : judged(measured, channel)) {
    const VectorXd weight = counts_of(*m).cwiseAbs2();
    const double count = std::max(weight.sum(), 1e-300);
    const double mean = weight.dot(m->measured) / count;
    sums.count += weight.sum();
    sums.samples += static_cast<double>(weight.size());
    sums.band_hz = sums.band_hz > 0.0 ? std::min(sums.band_hz, m->band_hz) : m->band_hz;
    sums.energy += weight.dot(m->measured.cwiseAbs2());
    sums.variance += weight.dot((m->measured.array() - mean).square().matrix());
    sums.before += error_before(*m).squaredNorm();
    sums.after += error_after(*m).squaredNorm();
  }
  sums.count = std::max(sums.count, 1.0);
  return sums;
}

}  // namespace

bool leaves_more_than(double share, const std::vector<MeasuredChannel>& measured, int channel) {
  const ErrorSums sums = error_sums(measured, channel);
  return sums.after > share * share * sums.energy;
}

double judged_seconds(const std::vector<MeasuredChannel>& measured, int channel) {
  double seconds = 0.0;
  for (const MeasuredChannel* m : judged(measured, channel))
    seconds += counts_of(*m).squaredNorm() * m->step;
  return seconds;
}

Gain measured_gain(const std::vector<MeasuredChannel>& measured, int channel, unsigned seed) {
  constexpr int kBlocks = 12;
  std::map<int, std::pair<double, double>> left;  // of each channel, before and after
  struct Block {
    int channel;
    double before, after;
  };
  std::vector<Block> all;
  for (const MeasuredChannel* m : judged(measured, channel)) {
    const Index n = m->measured.size();
    const VectorXd left_before = error_before(*m), left_after = error_after(*m);
    for (int b = 0; b < kBlocks; ++b) {
      const Index from = n * b / kBlocks, count = n * (b + 1) / kBlocks - from;
      all.push_back({m->channel, left_before.segment(from, count).squaredNorm(),
                     left_after.segment(from, count).squaredNorm()});
    }
    left[m->channel].first += left_before.squaredNorm();
    left[m->channel].second += left_after.squaredNorm();
  }
  if (all.empty()) return {};
  // A joint that hardly moves measures its noise alone: by its share of what is measured it would
  // outweigh all others.
  VectorXd before(static_cast<Index>(all.size())), after = before;
  for (Index k = 0; k < before.size(); ++k) {
    const Block& block = all[static_cast<std::size_t>(k)];
    const auto& [was, is] = left.at(block.channel);
    const double unit = std::max(std::min(was, is), 1e-300);
    before(k) = block.before / unit;
    after(k) = block.after / unit;
  }
  return block_bootstrap_gain(before, after, 0.95, seed);
}

std::optional<int> harmed_channel(const std::vector<MeasuredChannel>& measured, int channels,
                                  const Settings& settings) {
  if (!judged_on_held_out(measured)) return std::nullopt;
  for (int c = 0; c < channels; ++c)
    if (judged_seconds(measured, c) > kLeastMotion &&
        leaves_more_than(settings.material_share, measured, c) &&
        measured_gain(measured, c, settings.seed).high < 0.0)
      return c;
  return std::nullopt;
}

void tell_measured(const std::vector<MeasuredChannel>& measured, bool unlike, bool extended,
                   unsigned seed, Verdict& verdict) {
  std::set<int> channels;
  for (const MeasuredChannel& m : measured) channels.insert(m.channel);
  double variance = 0.0, before = 0.0, after = 0.0;
  for (const int channel : channels) {
    const ErrorSums sums = error_sums(measured, channel);
    const double unit = unlike ? std::max(sums.variance, 1e-300) : 1.0;
    variance += sums.variance / unit;
    before += sums.before / unit;
    after += sums.after / unit;
  }
  verdict.relative_error_before = std::sqrt(before / std::max(variance, 1e-300));
  verdict.relative_error_after = std::sqrt(after / std::max(variance, 1e-300));
  if (!judged_on_held_out(measured)) return;
  verdict.held_out = measured_gain(measured, -1, seed);
  if (extended && verdict.causes.size() == 1) verdict.causes.front().held_out = verdict.held_out;
}

double noise_floor(const Selection& selection, const Design& design, int channel) {
  double energy = 0.0, count = 0.0;
  const auto& noise = selection.noise.noise;
  for (std::size_t i = 0; i < design.segments().size() && i < noise.size(); ++i) {
    const Segment& s = design.segments()[i];
    if (s.channel != channel || s.holdout || noise[i].variance.size() == 0) continue;
    energy += 2.0 * noise[i].variance.sum();
    count += static_cast<double>(s.samples);
  }
  return std::sqrt(energy / std::max(count, 1.0));
}

void add_error(const std::string& domain, const std::vector<MeasuredChannel>& measured, int channel,
               unsigned seed, ChannelFinding& finding) {
  const ErrorSums sums = error_sums(measured, channel);
  finding.measured_rms = std::sqrt(sums.energy / sums.count);
  finding.standard_deviation = std::sqrt(sums.variance / sums.count);
  finding.compared_below_hz = sums.band_hz;
  finding.compared_share = sums.samples > 0.0 ? sums.count / sums.samples : 0.0;
  finding.domains.push_back({domain, finding.unit, std::sqrt(sums.before / sums.count),
                             std::sqrt(sums.after / sums.count),
                             measured_gain(measured, channel, seed)});
  if (finding.nothing_to_explain()) return;
  const auto unexplained = [&](double error) {
    return std::min(error / std::max(sums.variance, 1e-300), 1.0);
  };
  finding.unexplained_before = unexplained(sums.before);
  finding.unexplained_after = unexplained(sums.after);
}

std::string channel_name(const DrivenSubject& subject, int channel) {
  const std::string& name = subject.model().joints[static_cast<std::size_t>(channel)].name;
  return name == "motor" ? "tau_m" : "effort of " + name;
}

ChannelFinding channel_finding(const DrivenSubject& subject,
                               const std::vector<MeasuredChannel>& measured, int channel,
                               double noise_floor, double quantum, const Settings& settings) {
  const DrivenJoint& joint = subject.model().joints[static_cast<std::size_t>(channel)];
  ChannelFinding finding;
  finding.unit = joint.revolute ? "N*m" : "N";
  finding.name = channel_name(subject, channel);
  finding.noise_floor = noise_floor;
  finding.quantum = quantum;
  finding.material_share = settings.material_share;
  add_error("force", measured, channel, settings.seed, finding);
  finding.plots = channel_plots(measured, channel, judged_on_held_out(measured), joint.revolute);
  return finding;
}

}  // namespace sinew::diagnosis
