// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnose_observed.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "identification/explain.h"
#include "identification/measure_plots.h"
#include "identification/observed_extension.h"
#include "identification/read_csv.h"
#include "identification/verdict_text.h"
#include "symbolic/print_mathml.h"

namespace sinew::diagnosis {
namespace {

using Clock = std::chrono::steady_clock;
using Eigen::Index;

constexpr Index shortest = 400;  // samples of a stretch that is worth taking

class ObservedRun {
 public:
  explicit ObservedRun(const ObservedRequest& request)
      : request_(request),
        subject_(request.rig.observation, request.rig.channels, request.identified,
                 request.runtime) {}

  Diagnosis operator()() {
    const auto start = Clock::now();
    Findings& f = result_.findings;
    f.model = request_.name;
    f.description = request_.description;
    f.model_hash = request_.hash;
    f.kind = request_.kind;
    for (const std::string& file : request_.logs) read(file, false);
    for (const std::string& file : request_.holdout) read(file, true);
    tell("comparing with the model", 0.2);
    prepare();
    tell("searching for causes", 0.3);
    const Explanation explanation = explain(subject_.problem(), request_.settings);
    f.verdict = explanation.verdict;
    tell("extending and measuring", 0.9);
    extend(explanation);
    describe_terms();
    f.headline = headline(f);
    f.next_step = next_step(f);
    f.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return std::move(result_);
  }

 private:
  void tell(const std::string& step, double share) const {
    if (request_.progress) request_.progress(step, share);
  }

  void read(const std::string& file, bool held_out) {
    tell("reading " + file, 0.0);
    ReadOptions options;
    options.map = request_.map;
    const Log log = read_csv(file, request_.rig.specs, options);
    int part = 0;
    for (const sinew::Segment& segment : log.segments) {
      if (segment.samples.rows() < shortest) continue;
      Recording r = request_.rig.recording(log, segment, subject_.open());
      r.name = log.segments.size() > 1 ? fmt::format("{} part {}", log.file, ++part) : log.file;
      subject_.add(std::move(r), held_out);
    }
    LogRecord record{log.file, log.sha256, held_out, log.rows, 0.0, log.period, {}};
    record.seconds = log.period * static_cast<double>(log.sample_count());
    for (const DataFault& fault : log.faults) record.faults.push_back(message(fault));
    result_.findings.logs.push_back(std::move(record));
  }

  void prepare() {
    if (request_.rig.free_zero)
      for (int c = 0; c < subject_.problem().channels; ++c) subject_.add_offset(c);
    subject_.prepare();
    if (request_.rig.complete) request_.rig.complete(subject_);
  }

  /// Adopted where the measured gain on held-out logs is positive with its interval.
  void extend(const Explanation& explanation) {
    Findings& f = result_.findings;
    const Design design(subject_.problem(), request_.settings);
    const bool any = std::any_of(f.verdict.causes.begin(), f.verdict.causes.end(),
                                 [&](const NamedCause& c) { return effect_of(c) >= 0; });
    result_.extended =
        any ? extended_observation(subject_, design, explanation) : request_.identified;
    const std::vector<MeasuredChannel> measured =
        measure_observation(subject_, design, result_.extended, request_.rig.free_zero);
    for (int c = 0; c < subject_.problem().channels; ++c)
      f.channels.push_back(
          channel(measured, c, subject_.units()(c) * noise_floor(explanation, design, c)));
    for (const LogRecord& log : f.logs)
      if (!log.held_out && any) result_.extended.logs.push_back({log.file, log.sha256});
    decide(any, measured_gain(measured, -1, true, 12, request_.settings.seed));
    f.extension.operations_before = observation_operations(subject_, request_.identified);
    f.extension.operations_after = observation_operations(subject_, result_.extended);
  }

  void decide(bool any, const Gain& gain) {
    Extension& e = result_.findings.extension;
    const std::string falls = fmt::format(
        "on the held-out logs the squared error falls by {:.1f} % (95 %: {:.1f} to "
        "{:.1f} %)",
        100.0 * gain.share, 100.0 * gain.low, 100.0 * gain.high);
    if (!any) {
      e.reason = "no cause with a term of its own was named";
    } else if (request_.holdout.empty()) {
      e.reason = "no held-out log was given (--holdout): a gain on the training log proves nothing";
    } else if (!(gain.low > 0.0)) {
      e.reason = falls + ", which includes nothing at all";
    } else {
      e.adopted = true;
      e.reason = falls;
      e.functions = {"observation"};
    }
  }

  ChannelFinding channel(const std::vector<MeasuredChannel>& measured, int index, double noise) {
    const ObservedChannel& named = request_.rig.channels[static_cast<std::size_t>(index)];
    ChannelFinding finding;
    finding.name = named.name;
    finding.unit = named.unit;
    finding.noise_floor = noise;
    const bool held_out = !request_.holdout.empty();
    double energy = 0.0, variance = 0.0, before = 0.0, after = 0.0, count = 0.0;
    for (const MeasuredChannel& m : measured) {
      if (m.channel != index || m.held_out != held_out) continue;
      energy += m.measured.squaredNorm();
      variance += (m.measured.array() - m.measured.mean()).square().sum();
      before += (m.measured - m.before).squaredNorm();
      after += (m.measured - m.after).squaredNorm();
      count += static_cast<double>(m.measured.size());
    }
    count = std::max(count, 1.0);
    finding.measured_rms = std::sqrt(energy / count);
    finding.unexplained_before = before / std::max(variance, 1e-300);
    finding.unexplained_after = after / std::max(variance, 1e-300);
    finding.domains.push_back({"sensor", named.unit, std::sqrt(before / count),
                               std::sqrt(after / count),
                               measured_gain(measured, index, held_out, 12, 1)});
    finding.plots = channel_plots(
        measured, index, held_out,
        {named.name, named.unit, request_.rig.position, request_.rig.position_unit, "N"});
    return finding;
  }

  /// rms of the noise that is left in the band, from the noise model of the final selection.
  static double noise_floor(const Explanation& explanation, const Design& design, int channel) {
    double energy = 0.0, count = 0.0;
    const auto& noise = explanation.selection.noise.noise;
    for (std::size_t i = 0; i < design.segments().size() && i < noise.size(); ++i) {
      const Segment& s = design.segments()[i];
      if (s.channel != channel || s.holdout || noise[i].variance.size() == 0) continue;
      energy += 2.0 * noise[i].variance.sum();
      count += static_cast<double>(s.samples);
    }
    return std::sqrt(energy / std::max(count, 1.0));
  }

  int effect_of(const NamedCause& cause) const {
    const int candidate = cause.members.front().candidate;
    return candidate < 0 ? -1 : subject_.origins()[static_cast<std::size_t>(candidate)].effect;
  }

  void describe_terms() {
    const auto& causes = result_.findings.verdict.causes;
    for (std::size_t c = 0; c < causes.size(); ++c) {
      CauseTerm term;
      term.cause = static_cast<int>(c);
      const int index = effect_of(causes[c]);
      if (index >= 0) {
        const ObservationEffect& effect =
            subject_.observation().effects[static_cast<std::size_t>(index)];
        term.effect = effect.id;
        term.mathml = mathml_equation(effect.left, effect.term);
        term.text = plain_equation(effect.left, effect.term);
        term.signature = effect.signature;
        term.excitation = effect.excitation;
      }
      result_.findings.terms.push_back(std::move(term));
    }
  }

  const ObservedRequest& request_;
  ObservedSubject subject_;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose_observed(const ObservedRequest& request) {
  return ObservedRun(request)();
}

}  // namespace sinew::diagnosis
